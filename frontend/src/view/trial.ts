// One trial at every step: signals by port, and snapshots of the fields.

import { lastUpTo } from "./nearest";
import type { Detail, Framed, Picture } from "../protocol";
import { type Curve, isHeld, type Signal } from "../run";

/** Times in a trial [s], the same in all trials of a run. */
export interface Times {
  readonly steps: Float64Array;
  readonly middles: Float64Array; // of the steps
  readonly snapshots: Float64Array;
}

export class Trial {
  readonly bytes: number;
  /** Where time can stop: at the snapshots of the fields, or where there are none at every step [s]. */
  readonly stops: Float64Array;

  readonly #frame: Framed<Picture> | Framed<Detail>;
  readonly #picture: Picture;
  readonly #columns = new Map<string, Float32Array>();
  readonly #times: Times;

  constructor(frame: Framed<Picture> | Framed<Detail>, picture: Picture, times: Times) {
    this.#frame = frame;
    this.#picture = picture;
    this.#times = times;
    const first = picture.fields[0];
    this.stops = first && frame.has(first.name) ? times.snapshots : times.steps;
    this.bytes = Object.entries(frame.header.arrays)
      .filter(([name]) => !name.startsWith("all."))
      .reduce((sum, [, { type, shape }]) => sum + shape.reduce((size, n) => size * n, type === "f4" ? 4 : 8), 0);
  }

  /** A signal of one port, by step. */
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
    return { time: isHeld(name) ? this.#times.middles : this.#times.steps, values: this.column(name, port) };
  }

  /** A signal at a time [s], linear between its own times. */
  at(name: Signal, port: number, time: number): number {
    const values = this.column(name, port);
    const place = Math.min(Math.max(time / this.#picture.step - (isHeld(name) ? 0.5 : 0), 0), values.length - 1);
    const before = Math.floor(place);
    const after = Math.min(before + 1, values.length - 1);
    const from = values[before]!;
    const between = from + (place - before) * (values[after]! - from);
    return Number.isNaN(between) ? from : between; // limits may be infinite
  }

  /** A field, snapshot by snapshot (S, X). */
  field(name: string): Float32Array {
    return this.#frame.array(name) as Float32Array;
  }

  /** A field along the structure at a time [s], linear between snapshots, into `out`. */
  shape(name: string, time: number, out: Float32Array): void {
    const field = this.field(name);
    const before = Math.max(lastUpTo(this.stops, time), 0);
    const after = Math.min(before + 1, this.stops.length - 1);
    const [since, whole] = [time - this.stops[before]!, this.stops[after]! - this.stops[before]!];
    const share = whole > 0 ? Math.min(Math.max(since / whole, 0), 1) : 0;
    const from = before * out.length;
    const to = after * out.length;
    for (let i = 0; i < out.length; i++) out[i] = field[from + i]! * (1 - share) + field[to + i]! * share;
  }
}
