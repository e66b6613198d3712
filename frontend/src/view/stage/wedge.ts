// The wedge in which the needle of a turning section must stay.

import { BufferGeometry, Group, Line } from "three";
import { moving } from "./beam";
import type { Paints } from "./paints";
import { DEPTH } from "./size";
import { lines } from "./solid";

const [INNER, OUTER, POINTS] = [0.95, 1.55, 33];

export class Wedge {
  readonly group = new Group();
  readonly #rim = new BufferGeometry();
  readonly #needle: Group = new Group();

  constructor(paints: Paints) {
    this.#rim.setAttribute("position", moving(POINTS + 2));
    const rim = new Line(this.#rim, paints.limit);
    rim.frustumCulled = false;
    this.#needle.add(lines([0.3, 0, 0, OUTER - 0.08, 0, 0], paints.needle));
    this.group.add(rim, this.#needle);
    this.group.position.z = DEPTH / 2 + 0.1;
  }

  /** Drawn angles. */
  take(x: number, y: number, low: number, high: number, angle: number): void {
    this.group.position.x = x;
    this.group.position.y = y;
    this.#needle.rotation.z = angle;
    const rim = this.#rim.getAttribute("position");
    const point = (k: number, radius: number, at: number) => rim.setXYZ(k, radius * Math.cos(at), radius * Math.sin(at), 0);
    point(0, INNER, low);
    for (let i = 0; i < POINTS; i++) point(i + 1, OUTER, low + (i / (POINTS - 1)) * (high - low));
    point(POINTS + 1, INNER, high);
    rim.needsUpdate = true;
  }
}
