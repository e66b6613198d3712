// "Find a parameter": leaves of the form only those that match.

export class Filter {
  /** Which folds were open before, while a filter is on. */
  private folds: Map<HTMLDetailsElement, boolean> | null = null;

  constructor(private readonly root: HTMLElement) {}

  /** Returns how many fields match; null where nothing is looked for. */
  apply(text: string): number | null {
    const words = text.toLowerCase().split(/\s+/).filter(Boolean);
    this.root.classList.toggle("filtering", words.length > 0);
    if (words.length === 0) {
      for (const element of this.root.querySelectorAll<HTMLElement>("[data-passed]")) delete element.dataset.passed;
      this.folds?.forEach((open, fold) => (fold.open = open));
      this.folds = null;
      return null;
    }
    this.folds ??= new Map([...this.root.querySelectorAll("details")].map((fold) => [fold, fold.open]));
    return sift(this.root, (said) => words.every((word) => said.includes(word)), false);
  }
}

/** Marks every field and group below `element` as passed or not; inside a group that matches everything passes. */
function sift(element: Element, matches: (words: string) => boolean, passed: boolean): number {
  let found = 0;
  for (const child of element.children) {
    if (!(child instanceof HTMLElement)) continue;
    const { words, group } = child.dataset;
    const own = passed || (words !== undefined && matches(words));
    if (words === undefined && group === undefined) {
      found += sift(child, matches, passed);
      continue;
    }
    const inside = group === undefined ? 0 : sift(child, matches, own);
    const here = inside > 0 || own;
    child.dataset.passed = String(here);
    if (here && child instanceof HTMLDetailsElement) child.open = true;
    found += inside > 0 ? inside : Number(own);
  }
  return found;
}
