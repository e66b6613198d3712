// What the actuator makes of its command: delivered against commanded effort, over the trial being looked at.

import type uPlot from "uplot";
import type { Port } from "../../protocol";
import { describe, figure } from "../../dom";
import { Measure, number } from "../format";
import { capital, effortOf, type Look, lookOf, type Token } from "../look";
import { simplifiedLoop } from "../plot/path";
import { Plot } from "../plot/plot";
import { extent } from "../plot/range";
import { counterpart, type Scene } from "../scene";
import { Card } from "./card";
import type { Hands, Panel } from "./panel";

interface Loop {
  command: Float32Array;
  delivered: Float32Array;
}

const NOTHING = new Float32Array(2).fill(NaN);

export class ActuatorLoop implements Panel {
  readonly card: Card;
  readonly #plot: Plot;
  readonly #figure = figure();
  readonly #look: Look;
  readonly #index: number;
  readonly #token: Token;
  #now: Loop | null = null;
  #pinned: Loop | null = null;
  #gain = 1;
  #unit = "";

  constructor(hands: Hands, ports: Port[], index: number) {
    this.#look = hands.look;
    this.#index = index;
    this.#token = lookOf(ports, index).token;
    this.#plot = new Plot(this.#figure, {
      look: hands.look,
      height: 290,
      dot: this.#token,
      xTitle: () => `command [${this.#unit}]`,
      over: (plot) => this.#over(plot),
    });
    this.card = new Card(this.#plot.legend.root);
    this.card.body.append(this.#figure);
  }

  draw(scene: Scene): void {
    const { run, pinned, trial } = scene;
    const port = run.ports[this.#index]!;
    this.#gain = run.picture.gains[this.#index] ?? 1;
    const detail = run.trial(trial);
    this.#now = detail && { command: detail.column("command", this.#index), delivered: detail.column("delivered", this.#index) };
    const other = pinned ? counterpart(pinned, port) : -1;
    const beside = other >= 0 ? pinned?.run.trial(trial) : null;
    this.#pinned = beside ? { command: beside.column("command", other), delivered: beside.column("delivered", other) } : null;

    const loops = [this.#now, this.#pinned].filter((loop) => loop !== null);
    const x = extent(loops.map(({ command }) => command));
    const y = extent(loops.map(({ delivered }) => delivered));
    const measure = new Measure(Math.max(-x[0], x[1], -y[0], y[1]), port.effort_unit);
    this.#unit = measure.unit;
    const lines = [
      { label: `gain ${number(this.#gain)}`, token: "faint" as const, dash: [5, 3], width: 1 },
      ...(this.#pinned ? [{ label: pinned!.label, token: this.#token, dash: [4, 3], width: 1, alpha: 0.65 }] : []),
      { label: this.#pinned ? "now" : "delivered", token: this.#token },
    ];
    this.#plot.draw(
      Float64Array.of(...x),
      lines.map((line) => ({ ...line, values: NOTHING })),
      { x, y, factor: measure.factor, xFactor: measure.factor },
    );

    this.card.title(`${capital(effortOf(port))} loop`, `delivered [${measure.unit}]`);
    const caption = detail
      ? `Trial ${trial}: ${share(this.#now!, this.#gain, port.effort_unit)}.`
      : `Trial ${trial} is on its way.`;
    this.card.caption(caption);
    describe(this.#figure, `Delivered against commanded ${effortOf(port)}. ${caption}`);
  }

  cursor(scene: Scene): void {
    const detail = scene.run.trial(scene.trial);
    this.#plot.point(detail && [detail.at("command", this.#index, scene.time), detail.at("delivered", this.#index, scene.time)]);
  }

  repaint(): void {
    this.#plot.repaint();
  }

  destroy(): void {
    this.#plot.destroy();
  }

  #over(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const scale = devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    const [low, high] = [plot.scales["x"]!.min!, plot.scales["x"]!.max!];
    stroke(
      plot,
      { command: Float32Array.of(low, high), delivered: Float32Array.of(low * this.#gain, high * this.#gain) },
      this.#look.colour("faint"),
      scale,
      [5 * scale, 3 * scale],
    );
    ctx.globalAlpha = 0.65;
    if (this.#pinned) stroke(plot, this.#pinned, this.#look.colour(this.#token), scale, [4 * scale, 3 * scale]);
    ctx.globalAlpha = 1;
    if (this.#now) stroke(plot, this.#now, this.#look.colour(this.#token), 1.4 * scale, []);
    ctx.restore();
  }
}

function stroke(plot: uPlot, { command, delivered }: Loop, colour: string, width: number, dash: number[]): void {
  const { ctx } = plot;
  const xs = command.map((value) => plot.valToPos(value, "x", true));
  const ys = delivered.map((value) => plot.valToPos(value, "y", true));
  ctx.strokeStyle = colour;
  ctx.lineWidth = width;
  ctx.setLineDash(dash);
  ctx.stroke(simplifiedLoop(xs, ys));
}

/** How far what is delivered stays from gain times command. */
function share({ command, delivered }: Loop, gain: number, unit: string): string {
  let largest = 0;
  for (let i = 0; i < command.length; i++) largest = Math.max(largest, Math.abs(delivered[i]! - gain * command[i]!));
  return `up to ${new Measure(largest, unit).text(largest)} off the line of gain ${number(gain)}`;
}
