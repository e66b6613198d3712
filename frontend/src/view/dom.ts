// Elements in one expression.

type Properties<Tag extends keyof HTMLElementTagNameMap> = Partial<Omit<HTMLElementTagNameMap[Tag], "style" | "dataset" | "attributes">> & {
  class?: string;
  attributes?: { [name: string]: string };
};

export function make<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  { class: name, attributes, ...properties }: Properties<Tag> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  if (name) element.className = name;
  for (const [key, value] of Object.entries(attributes ?? {})) element.setAttribute(key, value);
  Object.assign(element, properties);
  element.append(...children);
  return element;
}

/** Sets a text only when it is another one, so that nothing is laid out again in vain. */
export function say(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** The element that a drawing lives in: one picture to a screen reader. */
export function figure(): HTMLElement {
  return make("div", { class: "figure", attributes: { role: "img" } });
}

export function describe(element: HTMLElement, text: string): void {
  if (element.getAttribute("aria-label") !== text) element.setAttribute("aria-label", text);
}
