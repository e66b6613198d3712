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
  readonly #line: Line;
  readonly #needle: Group = new Group();

  constructor(paints: Paints) {
    this.#rim.setAttribute("position", moving(POINTS + 2));
    this.#line = new Line(this.#rim, paints.limit);
    this.#line.frustumCulled = false;
    this.#needle.add(lines([0.3, 0, 0, OUTER - 0.08, 0, 0], paints.needle));
    this.group.add(this.#line, this.#needle);
    this.group.position.z = DEPTH / 2 + 0.1;
  }

  /** Tangents of the drawn angles; a limit that is infinite is none, and one alone is a single stroke. */
  take(x: number, y: number, lowest: number, highest: number, slope: number): void {
    this.group.position.x = x;
    this.group.position.y = y;
    this.#needle.rotation.z = Math.atan(slope);
    const [bounded, capped] = [Number.isFinite(lowest), Number.isFinite(highest)];
    this.#line.visible = bounded || capped;
    this.#rim.setDrawRange(bounded ? 0 : POINTS, bounded && capped ? POINTS + 2 : 2);
    const [low, high] = [Math.atan(lowest), Math.atan(highest)];
    const rim = this.#rim.getAttribute("position");
    const point = (k: number, radius: number, at: number) => rim.setXYZ(k, radius * Math.cos(at), radius * Math.sin(at), 0);
    point(0, INNER, low);
    for (let i = 0; i < POINTS; i++) point(i + 1, OUTER, low + (i / (POINTS - 1)) * (high - low));
    point(POINTS + 1, INNER, high);
    rim.needsUpdate = true;
  }
}
