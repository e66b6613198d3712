// One trial at every step: signals by port, and snapshots of the fields.

import type { Detail, Framed, Picture } from "../protocol";
import type { Curve, Signal } from "../run";

export class Trial {
  readonly bytes: number;
  readonly snapshots: number;

  readonly #frame: Framed<Picture> | Framed<Detail>;
  readonly #picture: Picture;
  readonly #columns = new Map<string, Float32Array>();
  readonly #time: Float64Array;

  constructor(frame: Framed<Picture> | Framed<Detail>, picture: Picture) {
    this.#frame = frame;
    this.#picture = picture;
    this.#time = Float64Array.from({ length: picture.steps + 1 }, (_, step) => step * picture.step);
    const first = picture.fields[0];
    this.snapshots = first && frame.has(first.name) ? (frame.shape(first.name)[0] ?? 0) : 0;
    this.bytes = Object.entries(frame.header.arrays)
      .filter(([name]) => !name.startsWith("all."))
      .reduce((sum, [, { type, shape }]) => sum + shape.reduce((size, n) => size * n, type === "f4" ? 4 : 8), 0);
  }

  /** A signal of one port, by step. `command` and `delivered` belong to the steps between: they have one value fewer. */
  column(name: Signal | "barrier", port: number): Float32Array {
    const key = `${name}.${port}`;
    let column = this.#columns.get(key);
    if (!column) {
      const all = this.#frame.array(name) as Float32Array;
      const width = this.#frame.shape(name)[1] ?? 1;
      column = width === 1 ? all : Float32Array.from({ length: all.length / width }, (_, i) => all[i * width + port]!);
      this.#columns.set(key, column);
    }
    return column;
  }

  curve(name: Signal | "barrier", port: number): Curve {
    const values = this.column(name, port);
    return { time: this.#time.subarray(0, values.length), values };
  }

  /** A signal at a time [s], linear between steps. */
  at(name: Signal, port: number, time: number): number {
    const values = this.column(name, port);
    const place = Math.min(Math.max(time / this.#picture.step, 0), values.length - 1);
    const before = Math.floor(place);
    const after = Math.min(before + 1, values.length - 1);
    const from = values[before]!;
    return from + (place - before) * (values[after]! - from) || from; // infinite limits: from stays
  }

  /** A field, snapshot by snapshot (S, X). */
  field(name: string): Float32Array {
    return this.#frame.array(name) as Float32Array;
  }

  /** A field along the structure at a time [s], linear between snapshots, into `out`. */
  shape(name: string, time: number, out: Float32Array): void {
    const field = this.field(name);
    const last = this.snapshots - 1;
    const place = Math.min(Math.max((time / this.#picture.duration) * last, 0), last);
    const before = Math.floor(place);
    const share = place - before;
    const from = before * out.length;
    const to = Math.min(before + 1, last) * out.length;
    for (let i = 0; i < out.length; i++) out[i] = field[from + i]! * (1 - share) + field[to + i]! * share;
  }
}
