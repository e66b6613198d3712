// What is painted behind the lines of a plot: forbidden regions and the borders between trials.

import type uPlot from "uplot";
import type { Curve } from "../../run";
import type { Look } from "../look";

const hatchings = new Map<string, CanvasPattern>();

/** Thin diagonal lines of a colour. */
export function hatching(ctx: CanvasRenderingContext2D, colour: string): CanvasPattern | string {
  const known = hatchings.get(colour);
  if (known) return known;
  const tile = document.createElement("canvas");
  tile.width = tile.height = 8;
  const pen = tile.getContext("2d");
  if (!pen) return colour;
  pen.strokeStyle = colour;
  pen.beginPath();
  for (const shift of [-8, 0, 8]) {
    pen.moveTo(shift, 8);
    pen.lineTo(shift + 8, 0);
  }
  pen.stroke();
  const pattern = ctx.createPattern(tile, "repeat");
  if (!pattern) return colour;
  hatchings.set(colour, pattern);
  return pattern;
}

/** Shades what lies beyond a limit: above an upper one (side 1), below a lower one (side -1). */
export function forbid(plot: uPlot, look: Look, limit: Curve, side: 1 | -1): void {
  const { ctx, bbox } = plot;
  const edge = side > 0 ? bbox.top : bbox.top + bbox.height;
  const within = (y: number) => Math.min(Math.max(y, bbox.top), bbox.top + bbox.height);
  const { time, values } = limit;
  ctx.save();
  ctx.beginPath();
  ctx.moveTo(plot.valToPos(time[0]!, "x", true), edge);
  for (let i = 0; i < values.length; i++) {
    // A limit that stays is one straight line, however many steps it has.
    const bend = i === 0 || i === values.length - 1 || values[i] !== values[i - 1] || values[i] !== values[i + 1];
    if (bend) ctx.lineTo(plot.valToPos(time[i]!, "x", true), within(plot.valToPos(values[i]!, "y", true)));
  }
  ctx.lineTo(plot.valToPos(time[time.length - 1]!, "x", true), edge);
  ctx.closePath();
  ctx.fillStyle = look.colour("constraint");
  ctx.globalAlpha = 0.1;
  ctx.fill();
  ctx.fillStyle = hatching(ctx, look.colour("constraint"));
  ctx.globalAlpha = 0.35;
  ctx.fill();
  ctx.restore();
}

/** Short ticks along the lower edge where one trial ends and the next begins. */
export function tickTrials(plot: uPlot, look: Look, trials: number, duration: number): void {
  const { ctx, bbox } = plot;
  ctx.save();
  ctx.strokeStyle = look.colour("faint");
  ctx.globalAlpha = 0.6;
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  for (let trial = 1; trial < trials; trial++) {
    const x = Math.round(plot.valToPos(trial * duration, "x", true));
    ctx.moveTo(x, bbox.top + bbox.height);
    ctx.lineTo(x, bbox.top + bbox.height - 6 * devicePixelRatio);
  }
  ctx.stroke();
  ctx.restore();
}
