// Everything that stands on the stage for one kind of run: structure, payload, mounting, limits and arrows.

import { type BufferGeometry, Group, Line, Mesh, type Object3D, SphereGeometry } from "three";
import type { Port } from "../../protocol";
import type { Run } from "../../run";
import type { Trial } from "../trial";
import { type Arrow, ForceArrow, TorqueArrow } from "./arrows";
import { Beam } from "./beam";
import { Ghost } from "./ghost";
import type { Paints } from "./paints";
import { Shape } from "./shape";
import { LENGTH, THICKNESS } from "./size";
import { base, block, lines } from "./solid";
import { Walls } from "./walls";
import { Wedge } from "./wedge";

interface Actor {
  port: Port;
  index: number;
  x: number;
  carrier: number; // the port whose displacement moves this one where there is no field, -1 for none
  arrow: Arrow;
  walls: Walls | null;
  wedge: Wedge | null;
  dot: Mesh | null; // where no field says how the structure moves
}

/** What a model is made for: runs that agree in it share one. */
export function modelKey(run: Run): string {
  const { ports, fields, span, tip, clamped } = run.picture;
  const limits = ports.map((_, index) => limited(run, index));
  return JSON.stringify([ports, fields, span, tip, clamped, limits, [...run.x]]);
}

export class Model {
  readonly group = new Group();
  readonly shape: Shape;
  readonly #beam: Beam | null;
  readonly #base: Group;
  readonly #payload: Group | null;
  readonly #actors: Actor[];
  readonly #scale: number;
  readonly #paints: Paints;
  #ghost: { shape: Shape; outline: Ghost; run: Run } | null = null;

  constructor(run: Run, paints: Paints) {
    const { ports, span, tip, clamped } = run.picture;
    this.#paints = paints;
    this.#scale = LENGTH / span;
    this.shape = new Shape(run, this.#scale);
    this.#beam = this.shape.bends ? new Beam(this.shape, paints) : null;
    this.#base = base(clamped, paints);
    const size = THICKNESS * Math.min(3, 1.25 + 0.65 * Math.cbrt(tip.mass));
    this.#payload = tip.mass > 0 ? block(size, size, 1.7 * size, paints) : null;
    this.#actors = ports.map((port, index) => {
      const x = port.x * this.#scale;
      const gap = (this.#payload && port.x > 0.99 * span ? size : THICKNESS) / 2;
      const turns = port.motion_unit === "rad";
      return {
        port,
        index,
        x,
        carrier: ports.findIndex((other) => other.motion_unit === "m" && other.x === port.x),
        arrow:
          port.kind === "force"
            ? new ForceArrow(gap, turns ? paints.rotation : paints.displacement)
            : new TorqueArrow(paints.rotation),
        walls: turns || !limited(run, index) ? null : new Walls(x, gap, paints),
        wedge: turns && limited(run, index) ? new Wedge(paints) : null,
        dot: this.shape.bends ? null : new Mesh(new SphereGeometry(0.2, 24, 16), turns ? paints.rotation : paints.displacement),
      };
    });
    const axis = lines([0, 0, 0, LENGTH + 1.2, 0, 0], paints.axis);
    const parts: (Object3D | null | undefined)[] = [axis, this.#beam?.group, this.#base, this.#payload];
    for (const { arrow, walls, wedge, dot } of this.#actors) parts.push(arrow.group, walls?.group, wedge?.group, dot);
    this.group.add(...parts.filter((part) => part != null));
  }

  take(run: Run, trial: Trial, time: number, factor: number): void {
    const { shape } = this;
    shape.take(trial, time, factor);
    this.#beam?.take(shape);
    if (run.picture.clamped === "pinned") this.#base.rotation.z = shape.angleAt(0);
    const payload = this.#payload;
    if (payload) {
      payload.position.set(LENGTH, this.#heightOfTip(trial, time, factor), 0);
      payload.rotation.z = shape.angleAt(LENGTH);
    }
    for (const { index, x, carrier, arrow, walls, wedge, dot } of this.#actors) {
      const height = shape.bends || carrier < 0 ? shape.heightAt(x) : this.#drawn(trial, carrier, time, factor);
      const largest = run.largest("delivered", index, null);
      arrow.take(x, height, largest > 0 ? trial.at("delivered", index, time) / largest : 0);
      const low = trial.at("low", index, time);
      const high = trial.at("high", index, time);
      walls?.take(low * factor * this.#scale, high * factor * this.#scale);
      wedge?.take(x, height, factor * low, factor * high, factor * trial.at("y", index, time));
      dot?.position.set(x, height, 0);
    }
  }

  /** Whether there are limits of displacements, and all of them out of sight. */
  get beyond(): boolean {
    const walls = this.#actors.flatMap((actor) => (actor.walls?.limited ? actor.walls : []));
    return walls.length > 0 && !walls.some(({ seen }) => seen);
  }

  /** The outline of another run, null for none. */
  haunt(run: Run | null, trial: Trial | null, time: number, factor: number): void {
    if (this.#ghost && this.#ghost.run !== run) {
      this.group.remove(this.#ghost.outline.line);
      this.#ghost.outline.dispose();
      this.#ghost = null;
    }
    if (!run) return;
    if (!this.#ghost) {
      const shape = new Shape(run, this.#scale); // metres are as large as those of the run in front
      if (!shape.bends) return;
      this.#ghost = { run, shape, outline: new Ghost(shape, this.#paints) };
      this.group.add(this.#ghost.outline.line);
    }
    this.#ghost.outline.line.visible = trial !== null;
    if (!trial) return;
    this.#ghost.shape.take(trial, time, factor);
    this.#ghost.outline.take(this.#ghost.shape);
  }

  dispose(): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof Line) (part.geometry as BufferGeometry).dispose();
    });
  }

  #drawn(trial: Trial, index: number, time: number, factor: number): number {
    return trial.at("y", index, time) * factor * this.#scale;
  }

  #heightOfTip(trial: Trial, time: number, factor: number): number {
    if (this.shape.bends) return this.shape.heightAt(LENGTH);
    const tip = this.#actors.find(({ port, x }) => port.motion_unit === "m" && x > 0.99 * LENGTH);
    return tip ? this.#drawn(trial, tip.index, time, factor) : 0;
  }
}

function limited(run: Run, index: number): boolean {
  return run.bounded("low", index) || run.bounded("high", index);
}
