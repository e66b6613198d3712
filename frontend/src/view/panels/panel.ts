// What every panel can do, and what panels are given to work with.

import type { Look } from "../look";
import type { Scene } from "../scene";
import type { Card } from "./card";

export interface Panel {
  readonly card: Card;
  draw(scene: Scene): void; // other data, another trial, another span
  cursor(scene: Scene): void; // only the time has moved
  repaint(): void; // only the colours have changed
  destroy(): void;
}

export interface Hands {
  look: Look;
  seek(time: number): void; // to a time on the time axis of the panels [s]
  jump(trial: number): void;
}
