// When something typed counts: at Enter, on leaving the field, or after a pause.

const PAUSE = 350; // ms: long enough to type the next digit

/** Calls `take` when what has been typed counts, and `settle` when the typing is over. */
export function onTyped(input: HTMLInputElement, take: () => void, settle: () => void): void {
  let timer = 0;
  input.addEventListener("input", () => {
    clearTimeout(timer);
    // "0." and "-" are on their way to a number.
    if (!/(^|[\s,])[-−+.]?$|[.e]$|e[-−+]$/i.test(input.value)) timer = window.setTimeout(take, PAUSE);
  });
  input.addEventListener("change", () => {
    clearTimeout(timer);
    take();
    settle();
  });
}
