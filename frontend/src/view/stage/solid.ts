// Blocks and discs with their edges drawn, so that they read well in flat light.

import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  LineSegments,
  Mesh,
} from "three";
import { DEPTH } from "./size";
import type { Paints } from "./paints";

function solid(geometry: BufferGeometry, paints: Paints): Group {
  const group = new Group();
  group.add(new Mesh(geometry, paints.block), new LineSegments(new EdgesGeometry(geometry, 30), paints.edge));
  return group;
}

export function block(width: number, height: number, depth: number, paints: Paints): Group {
  return solid(new BoxGeometry(width, height, depth), paints);
}

/** Lies in the plane of motion; a cross on it shows how it turns. */
export function disc(radius: number, depth: number, paints: Paints): Group {
  const group = solid(new CylinderGeometry(radius, radius, depth, 40).rotateX(Math.PI / 2), paints);
  const out = depth / 2 + 0.01;
  const spokes = [0, 1, 2, 3].flatMap((quarter) => {
    const [x, y] = [Math.cos((quarter * Math.PI) / 2), Math.sin((quarter * Math.PI) / 2)];
    return [0.25 * radius * x, 0.25 * radius * y, out, 0.85 * radius * x, 0.85 * radius * y, out];
  });
  group.add(lines(spokes, paints.edge));
  return group;
}

export function lines(points: number[], material: Paints["edge"]): LineSegments {
  return new LineSegments(new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3)), material);
}

/** Diagonal strokes over a rectangle that faces the viewer, as draughtsmen mark what does not move. */
export function hatch(left: number, bottom: number, width: number, height: number, out: number, step: number): number[] {
  const points: number[] = [];
  for (let shift = step - height; shift < width; shift += step) {
    const [from, to] = [Math.max(shift, 0), Math.min(shift + height, width)];
    if (to > from) points.push(left + from, bottom + from - shift, out, left + to, bottom + to - shift, out);
  }
  return points;
}

/** The mounting at x = 0: a hatched block that holds, a disc that turns, or nothing. */
export function base(clamped: "clamped" | "pinned" | "free", paints: Paints): Group {
  const group = new Group();
  if (clamped === "clamped") {
    const [width, height, depth] = [0.8, 2.2, 1.35 * DEPTH];
    const wall = block(width, height, depth, paints);
    wall.position.x = -width / 2;
    group.add(wall, lines(hatch(-width, -height / 2, width, height, depth / 2 + 0.01, 0.24), paints.faint));
  } else if (clamped === "pinned") {
    group.add(disc(0.62, 1.15 * DEPTH, paints));
  }
  return group;
}
