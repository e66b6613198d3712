// Below the stage: how much deflections are exaggerated, and the way back to the first view.

import { make, say } from "../dom";
import { fromSlider, toSlider } from "./exaggeration";
import { timesText } from "./hud";

export interface ToolEvents {
  exaggerate(factor: number): void; // 0: as fits
  reset(): void;
}

export class StageTools {
  readonly root = make("div", { class: "stage-tools" });
  readonly #slider = make("input", { type: "range", min: "0", max: "1000", attributes: { "aria-label": "Exaggeration of deflections" } });
  readonly #fits = make("input", { type: "checkbox" });
  readonly #text = make("span", { class: "times" });
  #factor = 1;

  constructor({ exaggerate, reset }: ToolEvents) {
    this.#slider.oninput = () => exaggerate(fromSlider(Number(this.#slider.value)));
    this.#fits.onchange = () => exaggerate(this.#fits.checked ? 0 : this.#factor);
    const back = make("button", { type: "button", onclick: reset }, "Reset view");
    this.root.append(this.#text, this.#slider, make("label", {}, this.#fits, " auto"), back);
  }

  show(factor: number, fits: boolean): void {
    this.#fits.checked = fits;
    if (factor === this.#factor && this.#text.textContent) return;
    this.#factor = factor;
    const text = timesText(factor);
    say(this.#text, text);
    this.#slider.setAttribute("aria-valuetext", text);
    if (document.activeElement !== this.#slider || fits) this.#slider.value = String(toSlider(factor));
  }
}
