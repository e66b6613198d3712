// The outline of the pinned run's structure.

import { BufferGeometry, LineLoop } from "three";
import { moving } from "./beam";
import type { Paints } from "./paints";
import type { Shape } from "./shape";
import { DEPTH, THICKNESS } from "./size";

export class Ghost {
  readonly line: LineLoop;
  readonly #geometry = new BufferGeometry();

  constructor(shape: Shape, paints: Paints) {
    this.#geometry.setAttribute("position", moving(2 * shape.x.length));
    this.line = new LineLoop(this.#geometry, paints.ghost);
    this.line.frustumCulled = false;
    this.line.renderOrder = 1;
  }

  take({ x, y, angle }: Shape): void {
    const position = this.#geometry.getAttribute("position");
    const count = x.length;
    for (let i = 0; i < count; i++) {
      const [across, along] = [(THICKNESS / 2) * Math.sin(angle[i]!), (THICKNESS / 2) * Math.cos(angle[i]!)];
      position.setXYZ(i, x[i]! - across, y[i]! + along, DEPTH / 2);
      position.setXYZ(2 * count - 1 - i, x[i]! + across, y[i]! - along, DEPTH / 2);
    }
    position.needsUpdate = true;
  }

  dispose(): void {
    this.#geometry.dispose();
  }
}
