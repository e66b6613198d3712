// The motion of a port against time, between its limits.

import type uPlot from "uplot";
import type { Port } from "../../protocol";
import type { Curve, Run } from "../../run";
import { describe, figure } from "../../dom";
import { Measure } from "../format";
import { capital, lookOf, motionOf, symbolOf } from "../look";
import { forbid, tickTrials } from "../plot/paint";
import { BEHIND, type Line, Plot } from "../plot/plot";
import { extent } from "../plot/range";
import { cursorOf, endOf, pinnedCurve, type Scene, trialOf } from "../scene";
import { Card } from "./card";
import type { Hands, Panel } from "./panel";

const SEEN = 1.7; // a limit farther away than so many times the motion is named instead of drawn

interface Limits {
  low: Curve | null;
  high: Curve | null;
}

export class Motion implements Panel {
  readonly card: Card;
  readonly #plot: Plot;
  readonly #figure = figure();
  readonly #hands: Hands;
  readonly #index: number;
  #limits: Limits = { low: null, high: null };
  #borders = 0; // how many trials have borders to be ticked
  #duration = 1;

  constructor(hands: Hands, index: number) {
    this.#hands = hands;
    this.#index = index;
    this.#plot = new Plot(this.#figure, {
      look: hands.look,
      height: 190,
      xTitle: "time t [s]",
      seek: hands.seek,
      under: (plot) => this.#under(plot),
    });
    this.card = new Card(this.#plot.legend.root);
    this.card.body.append(this.#figure);
  }

  draw(scene: Scene): void {
    const { run } = scene;
    const port = run.ports[this.#index]!;
    const look = lookOf(run.ports, this.#index);
    const trial = trialOf(scene);
    const curve = run.curve("y", this.#index, trial);
    const behind = pinnedCurve(scene, "y", port, curve);
    const largest = run.largest("y", this.#index, trial);
    const measure = new Measure(largest || 1, port.motion_unit);
    const says = (value: number) => measure.text(value);
    this.#limits = this.#seenLimits(run, trial, Math.max(largest, behind ? extent([behind])[1] : 0));
    this.#borders = trial === null ? run.picture.trials : 0;
    this.#duration = run.picture.duration;

    const lines: Line[] = [];
    if (behind) lines.push({ label: scene.pinned!.label, token: look.token, values: behind, ...BEHIND, says });
    if (run.picture.tracking) {
      lines.push({
        label: "reference",
        token: "reference",
        values: run.curve("reference", this.#index, trial).values,
        dash: [1.5, 2.5],
        says,
      });
    }
    for (const [side, limit] of Object.entries(this.#limits) as [keyof Limits, Curve | null][]) {
      const unlisted = side === "high" && this.#limits.low !== null;
      if (limit)
        lines.push({ label: "constraint", token: "constraint", values: limit.values, dash: [6, 4], width: 1.2, unlisted });
    }
    lines.push({ label: behind ? "now" : symbolOf(port), token: look.token, values: curve.values, dash: look.dash, says });
    this.#plot.draw(curve.time, lines, {
      x: [0, endOf(scene)],
      y: extent(lines.map(({ values }) => values)),
      factor: measure.factor,
    });

    this.card.title(capital(motionOf(port)), `${symbolOf(port)} [${measure.unit}]`);
    const caption = this.#sentence(scene, port, measure);
    this.card.caption(caption);
    describe(this.#figure, `${capital(motionOf(port))} against time. ${caption}`);
  }

  cursor(scene: Scene): void {
    this.#plot.cursor(cursorOf(scene));
  }

  repaint(): void {
    this.#plot.repaint();
  }

  destroy(): void {
    this.#plot.destroy();
  }

  #seenLimits(run: Run, trial: number | null, largest: number): Limits {
    const seen = (name: "low" | "high") => {
      const limit = run.curve(name, this.#index, trial);
      const nearest = limit.values.reduce((least, value) => Math.min(least, Math.abs(value)), Infinity);
      return nearest < SEEN * largest ? limit : null;
    };
    return { low: seen("low"), high: seen("high") };
  }

  /** "Largest 160 mm in trial 0; constraint −200 … 200 mm." */
  #sentence({ run, trial, span }: Scene, port: Port, measure: Measure): string {
    const within = span === "trial" ? trial : null;
    const largest = `Largest ${measure.text(run.largest("y", this.#index, within))} ${span === "trial" ? `in trial ${trial}` : "in all trials"}`;
    const limits = (["low", "high"] as const).map((name) => run.curve(name, this.#index, within).values);
    const [low, high] = limits.map((values) => values[0]!) as [number, number];
    if (low === -Infinity && high === Infinity) return `${largest}; no constraint.`;
    if (limits.some((values) => values.some((value) => value !== values[0]))) return `${largest}; the constraint moves.`;
    const measured = new Measure(Math.max(...[low, high].map(Math.abs).filter(Number.isFinite)), port.motion_unit);
    const range = low === -high ? `±${measured.text(high)}` : `${measured.number(low)} … ${measured.text(high)}`;
    return `${largest}; constraint ${range}${this.#limits.low || this.#limits.high ? "" : " (beyond the plot)"}.`;
  }

  #under(plot: uPlot): void {
    if (this.#limits.high) forbid(plot, this.#hands.look, this.#limits.high, 1);
    if (this.#limits.low) forbid(plot, this.#hands.look, this.#limits.low, -1);
    tickTrials(plot, this.#hands.look, this.#borders, this.#duration);
  }
}
