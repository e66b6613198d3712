// The structure as one deforming box: its vertices are moved in place.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, LineSegments, Mesh } from "three";
import type { Paints } from "./paints";
import type { Shape } from "./shape";
import { DEPTH, THICKNESS } from "./size";

const UP = THICKNESS / 2;
const OUT = DEPTH / 2;
const FACES = [
  // The two edges of each long face as (up, out), such that its triangles look outwards; `turned` faces have normals that turn.
  {
    edges: [
      [1, 1],
      [1, -1],
    ],
    turned: 1,
    out: 0,
  },
  {
    edges: [
      [-1, -1],
      [-1, 1],
    ],
    turned: -1,
    out: 0,
  },
  {
    edges: [
      [-1, 1],
      [1, 1],
    ],
    turned: 0,
    out: 1,
  },
  {
    edges: [
      [1, -1],
      [-1, -1],
    ],
    turned: 0,
    out: -1,
  },
] as const;
const LINE = 0.03; // half the width of the centre line

export class Beam {
  readonly group = new Group();
  readonly #count: number;
  readonly #every: number; // a section line at every so many stations
  readonly #faces = new BufferGeometry();
  readonly #sections = new BufferGeometry();
  readonly #centre = new BufferGeometry();

  constructor(shape: Shape, paints: Paints) {
    this.#count = shape.x.length;
    this.#every = Math.max(1, Math.round(this.#count / 26));
    const vertices = this.#count * 2;
    this.#faces.setAttribute("position", moving(FACES.length * vertices));
    this.#faces.setAttribute("normal", moving(FACES.length * vertices));
    this.#faces.setIndex(FACES.flatMap((_, face) => strip(this.#count, face * vertices)));
    this.#sections.setAttribute("position", moving(4 * Math.ceil(this.#count / this.#every)));
    this.#centre.setAttribute("position", moving(vertices));
    this.#centre.setIndex(strip(this.#count, 0));
    this.group.add(
      new Mesh(this.#faces, paints.body),
      new LineSegments(this.#sections, paints.section),
      new Mesh(this.#centre, paints.centre),
    );
    // The bounds of a shape that moves are not worth working out each frame: it is always in view.
    for (const part of this.group.children) part.frustumCulled = false;
  }

  take({ x, y, angle }: Shape): void {
    const position = this.#faces.getAttribute("position") as BufferAttribute;
    const normal = this.#faces.getAttribute("normal") as BufferAttribute;
    const section = this.#sections.getAttribute("position") as BufferAttribute;
    const centre = this.#centre.getAttribute("position") as BufferAttribute;
    let vertex = 0;
    for (const { edges, turned, out } of FACES) {
      for (let i = 0; i < this.#count; i++) {
        const [sine, cosine] = [Math.sin(angle[i]!), Math.cos(angle[i]!)];
        for (const [up, side] of edges) {
          position.setXYZ(vertex, x[i]! - up * UP * sine, y[i]! + up * UP * cosine, side * OUT);
          normal.setXYZ(vertex++, -turned * sine, turned * cosine, out);
        }
      }
    }
    for (let i = 0, k = 0; i < this.#count; i += this.#every, k += 4) {
      const [across, along] = [UP * Math.sin(angle[i]!), UP * Math.cos(angle[i]!)];
      section.setXYZ(k, x[i]! + across, y[i]! - along, OUT);
      section.setXYZ(k + 1, x[i]! - across, y[i]! + along, OUT);
      section.setXYZ(k + 2, x[i]! - across, y[i]! + along, OUT);
      section.setXYZ(k + 3, x[i]! - across, y[i]! + along, -OUT);
    }
    for (let i = 0; i < this.#count; i++) {
      const [across, along] = [LINE * Math.sin(angle[i]!), LINE * Math.cos(angle[i]!)];
      centre.setXYZ(2 * i, x[i]! + across, y[i]! - along, OUT + 0.01);
      centre.setXYZ(2 * i + 1, x[i]! - across, y[i]! + along, OUT + 0.01);
    }
    for (const attribute of [position, normal, section, centre]) attribute.needsUpdate = true;
  }
}

export function moving(vertices: number): BufferAttribute {
  return new BufferAttribute(new Float32Array(3 * vertices), 3).setUsage(DynamicDrawUsage);
}

/** Triangles between two edges whose vertices alternate. */
function strip(stations: number, first: number): number[] {
  const index: number[] = [];
  for (let i = 0; i < stations - 1; i++) {
    const [a, b] = [first + 2 * i, first + 2 * i + 1];
    index.push(a, a + 2, b + 2, a, b + 2, b);
  }
  return index;
}
