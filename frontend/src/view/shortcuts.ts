// Keys that work anywhere on the page, except where one types.

export function onKeys(keys: { [key: string]: () => void }): void {
  document.addEventListener("keydown", (event) => {
    const act = keys[event.key];
    if (!act || event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
    if (typing(event.target) || (event.key === " " && pressed(event.target))) return;
    event.preventDefault();
    act();
  });
}

function typing(target: EventTarget | null): boolean {
  if (target instanceof HTMLInputElement) return !["range", "checkbox", "radio", "button"].includes(target.type);
  return (
    target instanceof HTMLTextAreaElement ||
    target instanceof HTMLSelectElement ||
    (target instanceof HTMLElement && target.isContentEditable)
  );
}

/** The space bar already means something on these. */
function pressed(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("button, summary, a, [type=checkbox], [type=radio]") !== null;
}
