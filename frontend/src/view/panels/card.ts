// The frame of a panel: a heading, a caption with a number or two, a legend and the drawing.

import { el, write } from "../../dom";

let cards = 0;

export class Card {
  readonly root: HTMLElement;
  readonly body = el("div", { class: "card-body" });
  readonly #title = el("span", {});
  readonly #unit = el("span", { class: "card-unit" });
  readonly #caption = el("p", { class: "card-caption" });

  constructor(...extras: HTMLElement[]) {
    const id = `card-${++cards}`;
    const heading = el("h3", { id }, this.#title, " ", this.#unit);
    this.root = el("article", { class: "card", "aria-labelledby": id }, heading, this.#caption, ...extras, this.body);
  }

  /** "Tip displacement" and "w(L, t) [mm]" */
  title(words: string, unit: string): void {
    write(this.#title, words);
    write(this.#unit, unit);
  }

  caption(text: string): void {
    write(this.#caption, text);
  }
}
