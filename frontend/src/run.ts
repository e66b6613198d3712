// A run as the page holds it: its overview, and the details of the trials that have come so far.

import type { Detail, Framed, Picture, Port } from "./protocol";
import { Trial } from "./view/trial";

const HELD = 48e6; // bytes of details; beyond it those farthest from the trial being looked at go

/** A signal against time. */
export interface Curve {
  time: Float64Array;
  values: Float32Array;
}

/** The signals that are kept by port, and the one that is a number of the whole structure. */
export type Signal = "y" | "reference" | "low" | "high" | "command" | "delivered" | "energy";

export class Run {
  readonly picture: Picture;
  readonly peaks: Float64Array; // (trials, ports)
  looked = 0; // the trial being looked at

  readonly #frame: Framed<Picture>;
  readonly #details = new Map<number, Trial>();
  readonly #columns = new Map<string, Float32Array>();
  readonly #largest = new Map<string, number>();
  #overviewTime: Float64Array | null = null;
  #held = 0;

  constructor(frame: Framed<Picture>) {
    this.#frame = frame;
    this.picture = frame.header;
    this.peaks = frame.array("peaks") as Float64Array;
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
    if (trial === null) return { time: this.#time(), values: this.overview(name, port) };
    const detail = this.#details.get(trial);
    if (detail) return detail.curve(name, port);
    const size = this.bucketed;
    return {
      time: this.#time().subarray(0, size),
      values: this.overview(name, port).subarray(trial * size, (trial + 1) * size),
    };
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

  /** Values of a signal that the overview has in one trial. */
  get bucketed(): number {
    return 2 * (this.#frame.shape("time")[0] ?? 0);
  }

  /** The largest modulus of a signal in a trial, or in the whole run. Infinite values (no constraint) do not count. */
  largest(name: Signal, port: number, trial: number | null): number {
    const key = `${name}.${port}.${trial}`;
    let largest = this.#largest.get(key);
    if (largest === undefined) {
      const size = this.bucketed;
      const all = this.overview(name, port);
      largest = modulus(trial === null ? all : all.subarray(trial * size, (trial + 1) * size));
      this.#largest.set(key, largest);
    }
    return largest;
  }

  /** A field over all trials: rows of X values, a few rows a trial. */
  field(name: string): { values: Float32Array; rows: number; perTrial: number } {
    const [trials = 0, perTrial = 0] = this.#frame.shape(`all.${name}`);
    return { values: this.#frame.array(`all.${name}`) as Float32Array, rows: trials * perTrial, perTrial };
  }

  /** The largest modulus of a field in a trial, or in the whole run. */
  largestOfField(name: string, trial: number | null): number {
    const key = `field ${name}.${trial}`;
    let largest = this.#largest.get(key);
    if (largest === undefined) {
      const { values, perTrial } = this.field(name);
      const size = perTrial * this.x.length;
      largest = modulus(trial === null ? values : values.subarray(trial * size, (trial + 1) * size));
      this.#largest.set(key, largest);
    }
    return largest;
  }

  peak(trial: number, port: number): number {
    return this.peaks[trial * this.ports.length + port] ?? NaN;
  }

  #time(): Float64Array {
    if (!this.#overviewTime) {
      const { trials, duration } = this.picture;
      const size = this.bucketed;
      this.#overviewTime = new Float64Array(trials * size);
      for (let i = 0; i < this.#overviewTime.length; i++) this.#overviewTime[i] = ((i + 0.5) * duration) / size;
    }
    return this.#overviewTime;
  }

  #keep(trial: number, frame: Framed<Picture> | Framed<Detail>): void {
    const detail = new Trial(frame, this.picture);
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
