// Puts the server's faults where they belong.

import { type Path, parsePath } from "../path";
import type { Fault } from "../protocol";
import { prose } from "./words";

/** Shows each fault beside its field, or the nearest table around it. Returns those that have no place. */
export function showFaults(root: HTMLElement, faults: readonly Fault[]): Fault[] {
  const places = [...root.querySelectorAll<HTMLElement>("[data-error]:not([data-typed])")].map((element) => ({
    element,
    path: parsePath(element.dataset.error ?? ""),
  }));
  const texts = new Map<HTMLElement, string[]>(places.map(({ element }) => [element, []]));
  const homeless: Fault[] = [];
  for (const fault of faults) {
    const path = parsePath(fault.at);
    const [nearest] = places.filter((each) => begins(path, each.path)).sort((a, b) => b.path.length - a.path.length);
    if (!nearest) homeless.push(fault);
    else texts.get(nearest.element)?.push(nearest.path.length < path.length ? `${fault.at} ${fault.text}` : fault.text);
  }
  for (const [element, said] of texts) {
    element.replaceChildren(...prose(said.join(" ")));
    mark(root, element, said.length > 0);
  }
  return homeless;
}

const begins = (path: Path, start: Path): boolean => start.length > 0 && start.every((key, index) => key === path[index]);

/** Tells the control that its value is at fault, and opens what it is folded in. */
function mark(root: HTMLElement, error: HTMLElement, wrong: boolean): void {
  if (error.id) root.querySelector(`[data-path][aria-describedby~="${error.id}"]`)?.setAttribute("aria-invalid", String(wrong));
  if (!wrong) return;
  for (let fold = error.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null) fold.open = true;
}
