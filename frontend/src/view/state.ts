// What of the view goes into a link: where one stands in the run, and how it is looked at.

import type { Span } from "./scene";
import { LEAST, MOST } from "./stage/exaggeration";

export interface ViewState {
  trial: number;
  time: number; // within the trial [s]
  exaggeration: number; // 0: as fits
  speed: number; // in real time
  span: Span;
  playing: boolean;
}

const FASTEST = 2; // of the speeds that are offered
const SLOWEST = 1 / 50;

/** How the page begins. Where motion is unwelcome nothing moves by itself. */
export function initial(): ViewState {
  return { trial: 0, time: 0, exaggeration: 0, speed: 0.25, span: "trial", playing: !still() };
}

/** The state that a link holds; a field that has no sense is as at the beginning. */
export function stateIn(link: unknown): ViewState {
  const given = (typeof link === "object" && link !== null ? link : {}) as { [field in keyof ViewState]?: unknown };
  const start = initial();
  const number = (field: "trial" | "time" | "exaggeration" | "speed", good: (value: number) => boolean) => {
    const value = given[field];
    return typeof value === "number" && Number.isFinite(value) && good(value) ? value : start[field];
  };
  return {
    trial: number("trial", (trial) => Number.isSafeInteger(trial) && trial >= 0),
    time: number("time", (time) => time >= 0),
    exaggeration: number("exaggeration", (factor) => factor === 0 || (factor >= LEAST && factor <= MOST)),
    speed: number("speed", (speed) => speed >= SLOWEST && speed <= FASTEST),
    span: given.span === "trial" || given.span === "run" ? given.span : start.span,
    playing: typeof given.playing === "boolean" ? given.playing && !still() : start.playing,
  };
}

const still = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;
