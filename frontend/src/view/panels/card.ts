// The frame of a panel: a heading, a caption with a number or two, a legend and the drawing.

import { make, say } from "../dom";

let cards = 0;

export class Card {
  readonly root: HTMLElement;
  readonly body = make("div", { class: "card-body" });
  readonly #title = make("span", {});
  readonly #unit = make("span", { class: "card-unit" });
  readonly #caption = make("p", { class: "card-caption" });

  constructor(...extras: HTMLElement[]) {
    const id = `card-${++cards}`;
    const heading = make("h3", { id }, this.#title, " ", this.#unit);
    this.root = make("article", { class: "card", attributes: { "aria-labelledby": id } }, heading, this.#caption, ...extras, this.body);
  }

  /** "Tip displacement" and "w(L, t) [mm]" */
  title(words: string, unit: string): void {
    say(this.#title, words);
    say(this.#unit, unit);
  }

  caption(text: string): void {
    say(this.#caption, text);
  }
}
