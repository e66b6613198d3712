// Markers on a line: a shape a port, so that lines are told apart without their colours.

import type uPlot from "uplot";
import type { Marker } from "../look";
import type { Line } from "./plot";

export function drawMarkers(plot: uPlot, line: Line, colour: string, background: string): void {
  const { ctx } = plot;
  const scale = devicePixelRatio;
  const x = plot.data[0];
  const room = plot.bbox.width / Math.max(1, x.length);
  const size = Math.min(3.2 * scale, Math.max(1.2 * scale, room * 0.32));
  ctx.save();
  ctx.fillStyle = line.dash ? background : colour; // the pinned run's are hollow
  ctx.strokeStyle = colour;
  ctx.globalAlpha = line.alpha ?? 1;
  ctx.lineWidth = scale;
  ctx.beginPath();
  for (let i = 0; i < line.values.length; i++) {
    const value = line.values[i]!;
    if (value > 0) outline(ctx, line.marker!, plot.valToPos(x[i]!, "x", true), plot.valToPos(value, "y", true), size);
  }
  ctx.fill();
  ctx.stroke();
  ctx.restore();
}

function outline(ctx: CanvasRenderingContext2D, marker: Marker, x: number, y: number, size: number): void {
  if (marker === "disc") {
    ctx.moveTo(x + size, y);
    ctx.arc(x, y, size, 0, 2 * Math.PI);
  } else if (marker === "square") {
    ctx.rect(x - size, y - size, 2 * size, 2 * size);
  } else {
    const side = 1.3 * size;
    ctx.moveTo(x, y - side);
    ctx.lineTo(x + side, marker === "diamond" ? y : y + side);
    ctx.lineTo(marker === "diamond" ? x : x - side, y + side);
    if (marker === "diamond") ctx.lineTo(x - side, y);
    ctx.closePath();
  }
}
