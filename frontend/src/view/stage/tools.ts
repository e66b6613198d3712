// Below the stage: how much deflections are exaggerated, and the way back to the first view.

import { el, write } from "../../dom";
import { fromSlider, toSlider } from "./exaggeration";
import { timesText } from "./hud";

export interface ToolEvents {
  exaggerate(factor: number): void; // 0: as fits
  reset(): void;
}

export class StageTools {
  readonly root = el("div", { class: "stage-tools" });
  readonly #slider = el("input", { type: "range", min: "0", max: "1000", "aria-label": "Exaggeration of deflections" });
  readonly #fits = el("input", { type: "checkbox" });
  readonly #text = el("span", { class: "times" });
  #factor = 1;

  constructor({ exaggerate, reset }: ToolEvents) {
    this.#slider.oninput = () => exaggerate(fromSlider(Number(this.#slider.value)));
    this.#fits.onchange = () => exaggerate(this.#fits.checked ? 0 : this.#factor);
    const back = el("button", { type: "button", onclick: reset }, "Reset view");
    this.root.append(this.#text, this.#slider, el("label", {}, this.#fits, " auto"), back);
  }

  show(factor: number, fits: boolean): void {
    this.#fits.checked = fits;
    if (factor === this.#factor && this.#text.textContent) return;
    this.#factor = factor;
    const text = timesText(factor);
    write(this.#text, text);
    this.#slider.setAttribute("aria-valuetext", text);
    if (document.activeElement !== this.#slider || fits) this.#slider.value = String(toSlider(factor));
  }
}
