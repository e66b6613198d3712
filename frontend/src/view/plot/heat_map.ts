// A field over time and place: an image behind the axes of a plot.

import type uPlot from "uplot";
import { describe, figure } from "../../dom";
import type { Look } from "../look";
import { paintField } from "./diverging";
import { Plot } from "./plot";

export interface Field {
  values: Float32Array; // rows of as many values as there are places
  rows: number;
  end: number; // of its time [s]
}

const NOTHING = new Float32Array(2).fill(NaN);

export class HeatMap {
  readonly root = figure();
  readonly #plot: Plot;
  readonly #canvas = document.createElement("canvas");
  readonly #pen = this.#canvas.getContext("2d");
  #field: Field | null = null;
  #span = 1;
  #image: ImageData | null = null;

  constructor(
    look: Look,
    height: number,
    seek: (time: number) => void,
    hovered: (value: number, time: number, place: number) => void,
  ) {
    this.#plot = new Plot(this.root, {
      look,
      height,
      xTitle: "time t [s]",
      seek,
      under: (plot) => this.#under(plot),
      hover: (at) => this.#hover(at, hovered),
    });
  }

  draw(field: Field, span: number, end: number, limit: number, colours: Uint32Array, says: string): void {
    if (field.rows === 0) return;
    const places = field.values.length / field.rows;
    if (!this.#image || this.#image.width !== field.rows || this.#image.height !== places) {
      this.#canvas.width = field.rows;
      this.#canvas.height = places;
      this.#image = new ImageData(field.rows, places);
    }
    paintField(this.#image, field.values, limit, colours);
    this.#pen?.putImageData(this.#image, 0, 0);
    this.#field = field;
    this.#span = span;
    this.#plot.draw(Float64Array.of(0, end), [{ label: "", token: "ink", values: NOTHING }], { x: [0, end], y: [0, span] });
    describe(this.root, says);
  }

  cursor(time: number): void {
    this.#plot.cursor(time);
  }

  destroy(): void {
    this.#plot.destroy();
  }

  #hover(at: [number, number] | null, hovered: (value: number, time: number, place: number) => void): void {
    if (!at || !this.#field) return hovered(NaN, NaN, NaN);
    const [time, place] = at;
    const { values, rows, end } = this.#field;
    const places = values.length / rows;
    const row = Math.min(Math.floor((time / end) * rows), rows - 1);
    const column = Math.min(Math.max(Math.round((place / this.#span) * (places - 1)), 0), places - 1);
    hovered(values[row * places + column] ?? NaN, time, place);
  }

  #under(plot: uPlot): void {
    if (!this.#field) return;
    const { ctx, bbox } = plot;
    const right = plot.valToPos(this.#field.end, "x", true);
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(this.#canvas, bbox.left, bbox.top, right - bbox.left, bbox.height);
  }
}
