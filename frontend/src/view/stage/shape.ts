// The structure as it is drawn at an instant: where its centre line is, and how its sections are turned.

import type { Run } from "../../run";
import type { Trial } from "../trial";
import { LENGTH } from "./size";

export class Shape {
  readonly x: Float32Array;
  readonly y: Float32Array;
  readonly angle: Float32Array; // of the sections
  readonly turns: boolean; // whether a field says how sections turn; else they are square to the centre line
  readonly bends: boolean; // whether there is a field at all

  readonly #displacement: string | null;
  readonly #rotation: string | null;
  readonly #across: number; // stage units in a metre of deflection
  readonly #tilt: number; // how many times as steep a slope is drawn for being as long as the stage

  /** `across`: stage units in a metre of deflection. Along, every structure is as long as the stage. */
  constructor(run: Run, across: number) {
    const { fields, span } = run.picture;
    const along = LENGTH / span;
    this.#across = across;
    this.#tilt = across / along;
    this.#displacement = fields.find(({ unit }) => unit === "m")?.name ?? null;
    this.#rotation = fields.find(({ unit }) => unit === "rad")?.name ?? null;
    this.bends = this.#displacement !== null && run.x.length > 1;
    this.turns = this.bends && this.#rotation !== null;
    this.x = this.bends ? run.x.map((x) => x * along) : Float32Array.of(0, LENGTH);
    this.y = new Float32Array(this.x.length);
    this.angle = new Float32Array(this.x.length);
  }

  /** Deflections are drawn `factor` times as large, and so are the tangents of all angles: what is square stays square. */
  take(trial: Trial, time: number, factor: number): void {
    if (!this.#displacement || !this.bends) return;
    const { x, y, angle } = this;
    trial.shape(this.#displacement, time, y);
    for (let i = 0; i < y.length; i++) y[i]! *= factor * this.#across;
    if (this.#rotation) {
      trial.shape(this.#rotation, time, angle);
      for (let i = 0; i < angle.length; i++) angle[i] = Math.atan(factor * this.#tilt * angle[i]!);
      return;
    }
    const last = y.length - 1;
    for (let i = 0; i <= last; i++) {
      const [before, after] = [i > 0 ? i - 1 : 0, i < last ? i + 1 : last];
      angle[i] = Math.atan((y[after]! - y[before]!) / (x[after]! - x[before]!));
    }
  }

  heightAt(x: number): number {
    return this.#at(this.y, x);
  }

  angleAt(x: number): number {
    return this.#at(this.angle, x);
  }

  #at(values: Float32Array, x: number): number {
    const { x: places } = this;
    let after = 1;
    while (after < places.length - 1 && places[after]! < x) after++;
    const from = places[after - 1]!;
    const share = Math.min(Math.max((x - from) / (places[after]! - from), 0), 1);
    return values[after - 1]! * (1 - share) + values[after]! * share;
  }
}
