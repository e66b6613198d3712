// The bar that says which value a colour stands for.

import { make, say } from "../dom";
import type { Measure } from "../format";

export class ColourBar {
  readonly root: HTMLElement;
  readonly #canvas = make("canvas", { width: 256, height: 1 });
  readonly #pen = this.#canvas.getContext("2d");
  readonly #image = new ImageData(256, 1);
  readonly #low = make("span", {});
  readonly #high = make("span", {});

  constructor() {
    this.root = make("div", { class: "colour-bar", attributes: { "aria-hidden": "true" } }, this.#low, this.#canvas, this.#high);
  }

  draw(limit: number, measure: Measure, colours: Uint32Array): void {
    new Uint32Array(this.#image.data.buffer).set(colours);
    this.#pen?.putImageData(this.#image, 0, 0);
    say(this.#low, measure.number(-limit));
    say(this.#high, `+${measure.text(limit)}`);
  }
}
