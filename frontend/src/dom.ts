// Elements in one expression.

type Listener = (event: Event) => void;
type Attributes = { [name: string]: string | number | boolean | undefined | Listener };

/** An element; attributes that are functions listen (`onclick`), `true` and `false` set and leave out. */
export function el<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

/** The element of the page with this id. */
export function place(id: string): HTMLElement {
  const found = document.getElementById(id);
  if (!found) throw new Error(`The page has no #${id}.`);
  return found;
}

/** Sets a text only where it differs, so that screen readers and layout are left alone. */
export function write(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** The element that a drawing lives in: one picture to a screen reader. */
export function figure(): HTMLElement {
  return el("div", { class: "figure", role: "img" });
}

/** What a screen reader says of a drawing. */
export function describe(element: HTMLElement, text: string): void {
  if (element.getAttribute("aria-label") !== text) element.setAttribute("aria-label", text);
}

let count = 0;

/** An id that no other element has. */
export const freshId = (): string => `e${++count}`;
