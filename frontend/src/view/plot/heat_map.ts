// A field over time and place: an image behind the axes of a plot.

import type uPlot from "uplot";
import { describe, figure } from "../../dom";
import type { Look } from "../look";
import { nearest } from "../nearest";
import { paintField } from "./diverging";
import { type Grid, gridOf } from "./grid";
import { Plot } from "./plot";

export interface Field {
  values: Float32Array; // a row for each time, of as many values as there are places
  time: Float64Array;
  place: Float32Array; // along the structure [m], which need not be even
  end: number; // of its time [s]
}

const [WIDEST, HIGHEST] = [2048, 256]; // of the image

const NOTHING = new Float32Array(2).fill(NaN);

export class HeatMap {
  readonly root = figure();
  readonly #plot: Plot;
  readonly #canvas = document.createElement("canvas");
  readonly #pen = this.#canvas.getContext("2d");
  #field: Field | null = null;
  #image: ImageData | null = null;
  #time: Grid | null = null;
  #place: Grid | null = null;

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
    if (field.time.length === 0 || field.place.length === 0) return;
    const [time, place] = [gridOf(field.time, WIDEST), gridOf(field.place, HIGHEST)];
    const [width, height] = [time.before.length, place.before.length];
    if (!this.#image || this.#image.width !== width || this.#image.height !== height) {
      this.#canvas.width = width;
      this.#canvas.height = height;
      this.#image = new ImageData(width, height);
    }
    paintField(this.#image, field.values, time, place, limit, colours);
    this.#pen?.putImageData(this.#image, 0, 0);
    [this.#field, this.#time, this.#place] = [field, time, place];
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
    // The value that is nearest, with its own time and place.
    const { values, time, place } = this.#field;
    const [row, column] = [nearest(time, at[0]), nearest(place, at[1])];
    if (row < 0 || column < 0) return hovered(NaN, NaN, NaN);
    hovered(values[row * place.length + column]!, time[row]!, place[column]!);
  }

  #under(plot: uPlot): void {
    if (!this.#field || !this.#time || !this.#place) return;
    const { ctx, bbox } = plot;
    const [left, right] = [this.#time.low, this.#time.high].map((time) => plot.valToPos(time, "x", true)) as [number, number];
    const [low, high] = [this.#place.low, this.#place.high].map((place) => plot.valToPos(place, "y", true)) as [number, number];
    ctx.save();
    ctx.beginPath();
    // Half of what is centred on an edge lies beyond it.
    ctx.rect(bbox.left, bbox.top, plot.valToPos(this.#field.end, "x", true) - bbox.left, bbox.height);
    ctx.clip();
    ctx.imageSmoothingEnabled = true;
    ctx.drawImage(this.#canvas, left, high, right - left, low - high);
    ctx.restore();
  }
}
