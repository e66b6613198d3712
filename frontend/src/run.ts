// A run as the page holds it: its overview, and the details of the trials that have come so far.

import type { Detail, Framed, Picture, Port } from "./protocol";
import { type Times, Trial } from "./view/trial";

const HELD = 48e6; // bytes of details; beyond it those farthest from the trial being looked at go

/** A signal against time. */
export interface Curve {
  time: Float64Array;
  values: Float32Array;
}

/** The signals that are kept by port, and the one that is a number of the whole structure. */
export type Signal = "y" | "reference" | "low" | "high" | "command" | "delivered" | "energy";

/** Efforts are held through a step and belong to its middle: there is one value fewer than there are times. */
export const isHeld = (name: Signal | "barrier"): boolean => name === "command" || name === "delivered";

export class Run {
  readonly picture: Picture;
  readonly peaks: Float64Array; // (trials, ports)
  looked = 0; // the trial being looked at

  readonly #frame: Framed<Picture>;
  readonly #timesInTrial: Times;
  readonly #details = new Map<number, Trial>();
  readonly #columns = new Map<string, Float32Array>();
  readonly #largest = new Map<string, number>();
  readonly #times = new Map<string, Float64Array>();
  #held = 0;

  constructor(frame: Framed<Picture>) {
    this.#frame = frame;
    this.picture = frame.header;
    this.peaks = frame.array("peaks") as Float64Array;
    const { steps, step } = this.picture;
    this.#timesInTrial = {
      steps: Float64Array.from({ length: steps + 1 }, (_, i) => i * step),
      middles: Float64Array.from({ length: steps }, (_, i) => (i + 0.5) * step),
      snapshots: Float64Array.from(frame.array("time_out")),
    };
    this.looked = this.picture.trial;
    if (frame.has("y")) this.#keep(this.picture.trial, frame); // a run that broke off in its first trial may have none
  }

  get ports(): Port[] {
    return this.picture.ports;
  }

  /** Where the fields are given, along the structure [m]; empty when there are none. */
  get x(): Float32Array {
    return this.#frame.has("x") ? (this.#frame.array("x") as Float32Array) : new Float32Array(0);
  }

  add(frame: Framed<Detail>): void {
    this.#keep(frame.header.trial, frame);
    this.#forget();
  }

  has(trial: number): boolean {
    return this.#details.has(trial);
  }

  trial(trial: number): Trial | null {
    return this.#details.get(trial) ?? null;
  }

  hasSignal(name: Signal): boolean {
    return this.#frame.has(`all.${name}`);
  }

  /** A signal at every step of a trial, or of all trials in buckets; a trial whose detail is not here yet is cut from these. */
  curve(name: Signal, port: number, trial: number | null): Curve {
    const detail = trial === null ? null : this.#details.get(trial);
    if (detail) return detail.curve(name, port);
    const [time, values] = [this.#time(name), this.overview(name, port)];
    if (trial === null) return { time, values };
    const size = this.#bucketed(name);
    return { time: time.subarray(0, size), values: values.subarray(trial * size, (trial + 1) * size) };
  }

  /** A signal over all trials: of each bucket its smallest and its largest value, in order of time. */
  overview(name: Signal, port: number): Float32Array {
    const key = `${name}.${port}`;
    let column = this.#columns.get(key);
    if (!column) {
      const all = this.#frame.array(`all.${name}`) as Float32Array;
      const width = this.#frame.shape(`all.${name}`)[3] ?? 1;
      column = new Float32Array(all.length / width);
      for (let i = 0; i < column.length; i++) column[i] = all[i * width + port]!;
      this.#columns.set(key, column);
    }
    return column;
  }

  /** Whether a signal is finite anywhere in the run: a limit that is not is none. */
  bounded(name: Signal, port: number): boolean {
    return this.overview(name, port).some(Number.isFinite);
  }

  /** The largest modulus of a signal in a trial, or in the whole run. Infinite values (no constraint) do not count. */
  largest(name: Signal, port: number, trial: number | null): number {
    const key = `${name}.${port}.${trial}`;
    let largest = this.#largest.get(key);
    if (largest === undefined) {
      const size = this.#bucketed(name);
      const all = this.overview(name, port);
      largest = modulus(trial === null ? all : all.subarray(trial * size, (trial + 1) * size));
      this.#largest.set(key, largest);
    }
    return largest;
  }

  /** A field at the snapshots of a trial, or over all trials: rows of X values, and their times. */
  field(name: string, trial: number | null): { values: Float32Array; time: Float64Array } {
    const detail = trial === null ? null : this.#details.get(trial);
    if (detail) return { values: detail.field(name), time: this.#timesInTrial.snapshots };
    const [, columns = 0] = this.#frame.shape(`all.${name}`);
    const [time, values] = [this.#columnTime(columns), this.#frame.array(`all.${name}`) as Float32Array];
    if (trial === null) return { values, time };
    const size = columns * this.x.length;
    return { values: values.subarray(trial * size, (trial + 1) * size), time: time.subarray(0, columns) };
  }

  /** The largest modulus of a field in a trial, or in the whole run. */
  largestOfField(name: string, trial: number | null): number {
    const key = `field ${name}.${trial}`;
    let largest = this.#largest.get(key);
    if (largest === undefined) {
      const [, columns = 0] = this.#frame.shape(`all.${name}`);
      const values = this.#frame.array(`all.${name}`) as Float32Array;
      const size = columns * this.x.length;
      largest = modulus(trial === null ? values : values.subarray(trial * size, (trial + 1) * size));
      this.#largest.set(key, largest);
    }
    return largest;
  }

  peak(trial: number, port: number): number {
    return this.peaks[trial * this.ports.length + port] ?? NaN;
  }

  /** Values of a signal that the overview has in one trial. */
  #bucketed(name: Signal): number {
    return 2 * (this.#frame.shape(`all.${name}`)[1] ?? 0);
  }

  /** Times of an overview: the two values of a bucket stand a quarter of it before and after its middle. */
  #time(name: Signal): Float64Array {
    const { duration, step } = this.picture;
    const size = this.#bucketed(name);
    return this.#inAllTrials(`${isHeld(name)}.${size}`, () => {
      const middles = this.#frame.array("time");
      const quarter = middles.length > 1 ? (middles[1]! - middles[0]!) / 4 : Infinity;
      return Float64Array.from({ length: size }, (_, i) => {
        const middle = Math.min(middles[i >> 1]! + (isHeld(name) ? step / 2 : 0), duration);
        const aside = Math.min(quarter, (duration - middle) / 2); // the last bucket may be a short one
        return i % 2 === 0 ? middle - aside : middle + aside;
      });
    });
  }

  /** Times of a field's columns, each in the middle of its snapshots. */
  #columnTime(columns: number): Float64Array {
    const { snapshots } = this.#timesInTrial;
    const length = Math.ceil(snapshots.length / columns);
    return this.#inAllTrials(`columns.${columns}`, () =>
      Float64Array.from({ length: columns }, (_, column) => {
        const last = Math.min((column + 1) * length, snapshots.length) - 1;
        return (snapshots[column * length]! + snapshots[last]!) / 2;
      }),
    );
  }

  /** Times of one trial, gone on with through all trials; kept under `key`. */
  #inAllTrials(key: string, ofOne: () => Float64Array): Float64Array {
    let times = this.#times.get(key);
    if (!times) {
      const [one, { trials, duration }] = [ofOne(), this.picture];
      times = Float64Array.from({ length: trials * one.length }, (_, i) => {
        return Math.floor(i / one.length) * duration + one[i % one.length]!;
      });
      this.#times.set(key, times);
    }
    return times;
  }

  #keep(trial: number, frame: Framed<Picture> | Framed<Detail>): void {
    const detail = new Trial(frame, this.picture, this.#timesInTrial);
    this.#held += detail.bytes - (this.#details.get(trial)?.bytes ?? 0);
    this.#details.set(trial, detail);
  }

  #forget(): void {
    while (this.#held > HELD && this.#details.size > 1) {
      const farthest = [...this.#details.keys()].reduce((a, b) =>
        Math.abs(b - this.looked) > Math.abs(a - this.looked) ? b : a,
      );
      this.#held -= this.#details.get(farthest)?.bytes ?? 0;
      this.#details.delete(farthest);
    }
  }
}

function modulus(values: Float32Array): number {
  let largest = 0;
  for (let i = 0; i < values.length; i++) {
    const size = Math.abs(values[i]!);
    if (size > largest && size < Infinity) largest = size;
  }
  return largest;
}
