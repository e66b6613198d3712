// The bar that says which value a colour stands for.

import { el, write } from "../../dom";
import type { Measure } from "../format";

export class ColourBar {
  readonly root: HTMLElement;
  readonly #canvas = el("canvas", { width: 256, height: 1 });
  readonly #pen = this.#canvas.getContext("2d");
  readonly #image = new ImageData(256, 1);
  readonly #low = el("span", {});
  readonly #high = el("span", {});

  constructor() {
    this.root = el("div", { class: "colour-bar", "aria-hidden": "true" }, this.#low, this.#canvas, this.#high);
  }

  draw(limit: number, measure: Measure, colours: Uint32Array): void {
    new Uint32Array(this.#image.data.buffer).set(colours);
    this.#pen?.putImageData(this.#image, 0, 0);
    write(this.#low, measure.number(-limit));
    write(this.#high, `+${measure.text(limit)}`);
  }
}
