// A button that unfolds a panel below it; Escape, a click elsewhere, or a choice folds it again.

import { el } from "../dom";

export class Menu {
  readonly element: HTMLElement;
  readonly button: HTMLButtonElement;
  readonly panel: HTMLElement;

  constructor(label: string, ...items: Node[]) {
    this.button = el("button", { type: "button", class: "unfolds", "aria-expanded": "false" }, label);
    this.button.addEventListener("click", () => this.toggle(this.button.getAttribute("aria-expanded") !== "true"));
    this.panel = el("div", { class: "menu", hidden: true }, ...items);
    this.element = el("div", { class: "holder" }, this.button, this.panel);
    this.element.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || this.panel.hidden) return;
      this.toggle(false);
      this.button.focus();
    });
    this.panel.addEventListener("click", (event) => {
      if ((event.target as Element).closest("[data-closes]")) this.toggle(false);
    });
    document.addEventListener("pointerdown", (event) => {
      if (!this.element.contains(event.target as Node)) this.toggle(false);
    });
    this.element.addEventListener("focusout", (event) => {
      if (event.relatedTarget instanceof Node && !this.element.contains(event.relatedTarget)) this.toggle(false);
    });
  }

  toggle(open: boolean): void {
    this.panel.hidden = !open;
    this.button.setAttribute("aria-expanded", String(open));
  }
}
