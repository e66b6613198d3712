// The range of a slider, and which number lies where on it.

import { significant } from "../numbers";
import type { Parameter } from "../protocol";

export interface Scale {
  low: number;
  high: number;
  log: boolean;
  whole: boolean;
}

/** Steps of a slider from end to end. */
export const TRAVEL = 1000;

const REACH = 30; // a log slider goes from a 30th of the value to 30 times it
const LINEAR_REACH = 3;
/** Bounds of whole numbers that are so much wider than the value say what is possible, not what is sensible. */
const WIDE = 10;

/** The slider for a value; null where none is known to be sensible. */
export function scaleFor(value: number | undefined, { type, range }: Pick<Parameter, "type" | "range">): Scale | null {
  if (value === undefined) return null;
  const whole = type.is === "integer";
  const floor = Math.max(range.ge ?? -Infinity, range.gt ?? -Infinity);
  const ceiling = Math.min(range.le ?? Infinity, range.lt ?? Infinity);
  const bounded = Number.isFinite(floor) && Number.isFinite(ceiling);
  const wide = whole && ceiling - floor > WIDE * Math.abs(value);
  if (bounded && !wide) return inside({ low: floor, high: ceiling, log: false, whole }, range);
  if (value === 0) return null;
  if (value > 0) {
    const low = Math.max(significant(value / REACH, 3), floor, whole ? 1 : 0);
    return inside({ low, high: Math.min(significant(value * REACH, 3), ceiling), log: true, whole }, range);
  }
  const reach = significant(LINEAR_REACH * Math.abs(value), 3);
  return inside({ low: Math.max(-reach, floor), high: Math.min(reach, ceiling), log: false, whole }, range);
}

/** The scale without ends that the value must not take: a bound that is excluded is kept away from, by a step of the slider. */
export function inside(scale: Scale, { gt = -Infinity, lt = Infinity }: Parameter["range"]): Scale {
  const low = scale.whole ? Math.ceil(scale.low) : scale.low;
  const high = scale.whole ? Math.floor(scale.high) : scale.high;
  const step = scale.whole ? 1 : (high - low) / TRAVEL;
  return { ...scale, low: low <= gt ? gt + step : low, high: high >= lt ? lt - step : high };
}

export const holds = (scale: Scale, value: number): boolean => scale.low <= value && value <= scale.high;

/** Where `value` lies, 0 to TRAVEL; beyond the ends it lies at the end. */
export function positionOf({ low, high, log }: Scale, value: number): number {
  const share = log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
  return Math.round(TRAVEL * Math.min(1, Math.max(0, Number.isNaN(share) ? 0 : share)));
}

/** The number at a position, no more precise than the slider is. */
export function numberAt({ low, high, log, whole }: Scale, position: number): number {
  const share = position / TRAVEL;
  const value = log ? low * (high / low) ** share : low + (high - low) * share;
  const decimals = Math.max(0, Math.ceil(-Math.log10((high - low) / TRAVEL)));
  const rounded = whole ? Math.round(value) : log ? significant(value, 3) : Number(value.toFixed(Math.min(decimals, 20)));
  return Math.min(Math.max(rounded, low), high); // rounding must not lead over the ends
}
