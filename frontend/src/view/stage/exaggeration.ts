// How many times as large as they are deflections are drawn.

import { LENGTH, REACH } from "./size";

const NICE = [1, 1.5, 2, 3, 4, 5, 6, 8];
export const [LEAST, MOST] = [0.1, 200];

/** The largest round factor at which a deflection [m] of a structure of that length [m] stays on the stage. */
export function fitting(deflection: number, span: number): number {
  if (!(deflection > 0)) return 1;
  const most = Math.min(Math.max((REACH * span) / (LENGTH * deflection), LEAST), MOST);
  const decade = 10 ** Math.floor(Math.log10(most) + 1e-9);
  return decade * NICE.reduce((best, nice) => (nice * decade <= most * (1 + 1e-9) ? nice : best), 1);
}

/** The slider is linear in the logarithm: 0 to 1000. */
export function fromSlider(position: number): number {
  const factor = LEAST * (MOST / LEAST) ** (position / 1000);
  return Number(factor.toPrecision(2));
}

export function toSlider(factor: number): number {
  return Math.round((1000 * Math.log(factor / LEAST)) / Math.log(MOST / LEAST));
}
