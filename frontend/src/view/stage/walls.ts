// The two plates between which a displacement must stay.

import { BoxGeometry, EdgesGeometry, Group, LineSegments, Mesh } from "three";
import type { Paints } from "./paints";
import { DEPTH } from "./size";
import { hatch, lines } from "./solid";

const SEEN = 3.6; // about where the stage ends
const [WIDTH, HEIGHT, ACROSS] = [2.6, 0.09, 1.5 * DEPTH];

export class Walls {
  readonly group = new Group();
  readonly #low: Group;
  readonly #high: Group;
  readonly #gap: number;
  #limited = false;

  /** `gap`: half the height of what must not touch them. */
  constructor(x: number, gap: number, paints: Paints) {
    this.#gap = gap;
    this.#low = plate(-1, paints);
    this.#high = plate(1, paints);
    this.group.add(this.#low, this.#high);
    this.group.position.x = x;
  }

  /** Whether there is a limit at the moment. */
  get limited(): boolean {
    return this.#limited;
  }

  get seen(): boolean {
    return [this.#low, this.#high].some(({ visible, position }) => visible && Math.abs(position.y) < SEEN);
  }

  /** Limits in stage units; what is infinite is no limit. */
  take(low: number, high: number): void {
    this.#limited = Number.isFinite(low) || Number.isFinite(high);
    place(this.#low, low - this.#gap);
    place(this.#high, high + this.#gap);
  }
}

function place(plate: Group, y: number): void {
  plate.visible = Math.abs(y) < 40;
  if (plate.visible) plate.position.y = y;
}

function plate(side: 1 | -1, paints: Paints): Group {
  const group = new Group();
  const box = new BoxGeometry(WIDTH, HEIGHT, ACROSS).translate(0, (side * HEIGHT) / 2, 0);
  const strokes = hatch(-WIDTH / 2, side > 0 ? HEIGHT : -HEIGHT - 0.24, WIDTH, 0.24, ACROSS / 2, 0.2);
  group.add(new Mesh(box, paints.wall), new LineSegments(new EdgesGeometry(box), paints.limit), lines(strokes, paints.limit));
  return group;
}
