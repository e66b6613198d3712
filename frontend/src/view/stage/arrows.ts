// Delivered efforts: a straight arrow for a force, one that bends round for a torque.

import { CatmullRomCurve3, ConeGeometry, CylinderGeometry, Group, Mesh, type Material, TubeGeometry, Vector3 } from "three";
import { DEPTH } from "./size";

const [SHAFT, HEAD, HEAD_LENGTH] = [0.055, 0.16, 0.34];
const LEAST = 0.02; // of the largest effort; less is not drawn

export interface Arrow {
  readonly group: Group;
  /** `share` of the largest effort, with its sign. */
  take(x: number, y: number, share: number): void;
}

export class ForceArrow implements Arrow {
  static readonly LONGEST = 1.9;
  readonly group = new Group();
  readonly #shaft: Mesh;
  readonly #head: Mesh;
  readonly #gap: number;

  /** `gap`: from the centre line to the surface that is pushed. */
  constructor(gap: number, material: Material) {
    this.#gap = gap;
    this.#shaft = new Mesh(new CylinderGeometry(SHAFT, SHAFT, 1, 12).translate(0, 0.5, 0), material);
    this.#head = new Mesh(new ConeGeometry(HEAD, HEAD_LENGTH, 16).translate(0, HEAD_LENGTH / 2, 0), material);
    this.group.add(this.#shaft, this.#head);
  }

  take(x: number, y: number, share: number): void {
    const size = Math.abs(share);
    this.group.visible = size > LEAST;
    if (!this.group.visible) return;
    const up = share > 0 ? 1 : -1;
    const length = size * ForceArrow.LONGEST;
    const head = Math.min(1, length / HEAD_LENGTH); // short arrows have smaller heads
    const shaft = length - head * HEAD_LENGTH;
    this.group.position.set(x, y + up * this.#gap, 0);
    this.group.rotation.z = up > 0 ? 0 : Math.PI;
    this.#shaft.visible = shaft > 0;
    this.#shaft.scale.set(head, Math.max(shaft, 1e-3), head);
    this.#head.position.y = shaft;
    this.#head.scale.setScalar(head);
  }
}

const [RADIUS, START, SWEEP, SEGMENTS, AROUND] = [0.82, (5 / 6) * Math.PI, 1.4 * Math.PI, 60, 8];

const ARC = new CatmullRomCurve3(
  Array.from({ length: 37 }, (_, i) => {
    const angle = START + (i / 36) * SWEEP;
    return new Vector3(RADIUS * Math.cos(angle), RADIUS * Math.sin(angle), 0);
  }),
);

export class TorqueArrow implements Arrow {
  readonly group = new Group();
  readonly #tube: TubeGeometry;
  readonly #head: Mesh;

  constructor(material: Material) {
    this.#tube = new TubeGeometry(ARC, SEGMENTS, SHAFT, AROUND);
    this.#head = new Mesh(new ConeGeometry(HEAD, HEAD_LENGTH, 16), material);
    this.group.add(new Mesh(this.#tube, material), this.#head);
    this.group.position.z = DEPTH / 2 + 0.2;
  }

  take(x: number, y: number, share: number): void {
    const size = Math.abs(share);
    this.group.visible = size > LEAST;
    if (!this.group.visible) return;
    const segments = Math.max(1, Math.round(size * SEGMENTS));
    this.#tube.setDrawRange(0, segments * AROUND * 6);
    const angle = START + (segments / SEGMENTS) * SWEEP;
    this.#head.position.set(RADIUS * Math.cos(angle), RADIUS * Math.sin(angle), 0);
    this.#head.rotation.z = angle;
    this.#head.scale.setScalar(Math.min(1, 0.4 + 2 * size));
    this.group.position.x = x;
    this.group.position.y = y;
    // Turned about the vertical axis, the arrow goes round the other way.
    this.group.rotation.y = share > 0 ? 0 : Math.PI;
  }
}
