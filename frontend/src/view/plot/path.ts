// Lines with as few corners as can be seen: a browser strokes a hundred corners in no time, but two thousand take milliseconds.

import type uPlot from "uplot";

const NEAR = 0.3; // how far a left-out point may lie from the line [px]
const COLUMN = 1.5; // points that share so much of the width are drawn as their extremes [CSS px]

/** Values against rising times as a path for uPlot. From each corner a line goes on for as long as it passes all points closely. */
export function simplified(plot: uPlot, times: Numbers, values: Numbers): uPlot.Series.Paths {
  const { bbox, scales } = plot;
  const [low, high] = [scales["x"]!.min!, scales["x"]!.max!];
  const across = bbox.width / (high - low);
  const up = heights(plot);
  const stroke = new Path2D();
  let [cornerX, cornerY, lastX, lastY] = [NaN, NaN, NaN, NaN];
  let [least, most] = [-Infinity, Infinity]; // slopes that pass all points since the corner
  let open = false;
  for (const i of telling(times, values, (high - low) / (bbox.width / (COLUMN * devicePixelRatio)))) {
    const x = bbox.left + (times[i]! - low) * across;
    const y = up(values[i]!);
    if (!Number.isFinite(y)) {
      if (open) stroke.lineTo(lastX, lastY);
      open = false;
      continue;
    }
    if (!open) {
      stroke.moveTo(x, y);
      [cornerX, cornerY, least, most, open] = [x, y, -Infinity, Infinity, true];
    } else {
      const slope = (y - cornerY) / (x - cornerX);
      if (slope < least || slope > most) {
        stroke.lineTo(lastX, lastY);
        [cornerX, cornerY, least, most] = [lastX, lastY, -Infinity, Infinity];
      }
      least = Math.max(least, (y - NEAR - cornerY) / (x - cornerX));
      most = Math.min(most, (y + NEAR - cornerY) / (x - cornerX));
    }
    [lastX, lastY] = [x, y];
  }
  if (open) stroke.lineTo(lastX, lastY);
  return { stroke, flags: 1 };
}

type Numbers = ArrayLike<number>;

/** Which points to draw: where many share a column, only its lowest and its highest, in their order. */
function telling(times: Numbers, values: Numbers, width: number): Iterable<number> {
  const last = times.length - 1;
  const dense = (times[last]! - times[0]!) / last < width / 3;
  const points: number[] = [];
  for (let i = 0; i <= last;) {
    const end = times[i]! + width;
    let [lowest, highest] = [i, i];
    const first = i++;
    for (; dense && i <= last && times[i]! < end; i++) {
      if (values[i]! < values[lowest]!) lowest = i;
      if (values[i]! > values[highest]!) highest = i;
    }
    if (lowest === highest) points.push(first);
    else points.push(Math.min(lowest, highest), Math.max(lowest, highest));
  }
  return points;
}

function heights(plot: uPlot): (value: number) => number {
  const { bbox, scales } = plot;
  const { min, max, distr } = scales["y"]!;
  const bottom = bbox.top + bbox.height;
  if (distr === 3) {
    const scale = bbox.height / Math.log10(max! / min!);
    return (value) => bottom - Math.log10(value / min!) * scale;
  }
  const scale = bbox.height / (max! - min!);
  return (value) => bottom - (value - min!) * scale;
}

/** The same for a line that may turn back: points are left out while they lie on the way from a corner ahead. */
export function simplifiedLoop(xs: Float32Array, ys: Float32Array): Path2D {
  const path = new Path2D();
  let [cornerX, cornerY] = [xs[0]!, ys[0]!];
  let [aheadX, aheadY, reach] = [0, 0, 0]; // direction from the corner, and how far along it the line has come
  path.moveTo(cornerX, cornerY);
  for (let i = 1; i < xs.length; i++) {
    const [x, y] = [xs[i]! - cornerX, ys[i]! - cornerY];
    const size = Math.hypot(x, y);
    if (reach === 0) {
      if (size > 2 * NEAR) [aheadX, aheadY, reach] = [x / size, y / size, size];
      continue;
    }
    const along = x * aheadX + y * aheadY;
    if (Math.abs(x * aheadY - y * aheadX) < NEAR && along > reach - NEAR) {
      reach = Math.max(reach, along);
      continue;
    }
    [cornerX, cornerY, reach] = [xs[i - 1]!, ys[i - 1]!, 0];
    path.lineTo(cornerX, cornerY);
    i--; // this point is the first after the new corner
  }
  path.lineTo(xs[xs.length - 1]!, ys[ys.length - 1]!);
  return path;
}
