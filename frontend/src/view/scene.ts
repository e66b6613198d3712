// What is to be seen at the moment; panels and stage draw from it and keep nothing of it.

import type { Port } from "../protocol";
import type { Curve, Run, Signal } from "../run";

export type Span = "trial" | "run";

export interface Pinned {
  run: Run;
  label: string;
}

export interface Scene {
  run: Run;
  pinned: Pinned | null;
  trial: number;
  time: number; // within the trial [s]
  span: Span;
}

/** The trial whose signals are to be seen, null for all of them. */
export function trialOf(scene: Scene): number | null {
  return scene.span === "trial" ? scene.trial : null;
}

/** Where the time cursor stands on the time axis of the panels [s]. */
export function cursorOf(scene: Scene): number {
  return scene.span === "trial" ? scene.time : scene.trial * scene.run.picture.duration + scene.time;
}

/** How far the time axis of the panels goes [s]. */
export function endOf(scene: Scene): number {
  const { duration, trials } = scene.run.picture;
  return scene.span === "trial" ? duration : duration * Math.max(1, trials, scene.pinned?.run.picture.trials ?? 0);
}

/** The pinned run's port that a port is to be compared with, -1 for none. */
export function counterpart(pinned: Pinned, port: Port): number {
  return pinned.run.ports.findIndex(({ name, motion_unit }) => name === port.name && motion_unit === port.motion_unit);
}

/** The same signal of the pinned run, at its own times; null when it has none. */
export function pinnedCurve(scene: Scene, name: Signal, port: Port | null): Curve | null {
  const { pinned } = scene;
  if (!pinned || !pinned.run.hasSignal(name)) return null;
  const index = port ? counterpart(pinned, port) : 0;
  const trial = trialOf(scene);
  if (index < 0 || (trial !== null && trial >= pinned.run.picture.trials)) return null;
  return pinned.run.curve(name, index, trial);
}
