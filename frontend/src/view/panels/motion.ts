// The motion of a port against time, between its limits.

import type uPlot from "uplot";
import type { Port } from "../../protocol";
import type { Curve, Run } from "../../run";
import { Measure } from "../format";
import { capital, type Look, lookOf, motionOf, symbolOf } from "../look";
import { forbid } from "../plot/paint";
import { BEHIND, type Line } from "../plot/plot";
import { extent } from "../plot/range";
import { pinnedCurve, type Scene, trialOf } from "../scene";
import type { Hands } from "./panel";
import { type TimeCourse, TimePanel, within } from "./time_panel";

const SEEN = 1.7; // a limit farther away than so many times the motion is named instead of drawn

const LIMIT = { label: "constraint", token: "constraint" as const, dash: [6, 4], width: 1.2 };

interface Limits {
  low: Curve | null;
  high: Curve | null;
}

export class Motion extends TimePanel {
  readonly #look: Look;
  readonly #index: number;
  #limits: Limits = { low: null, high: null };

  constructor(hands: Hands, index: number) {
    super(hands, 190);
    this.#look = hands.look;
    this.#index = index;
  }

  protected course(scene: Scene): TimeCourse {
    const { run } = scene;
    const port = run.ports[this.#index]!;
    const look = lookOf(run.ports, this.#index);
    const trial = trialOf(scene);
    const curve = run.curve("y", this.#index, trial);
    const behind = pinnedCurve(scene, "y", port);
    const largest = run.largest("y", this.#index, trial);
    const measure = new Measure(largest || 1, port.motion_unit);
    const says = (value: number) => measure.text(value);
    this.#limits = this.#seenLimits(run, trial, Math.max(largest, behind ? extent([behind.values])[1] : 0));

    const lines: Line[] = [];
    if (behind) lines.push({ label: scene.pinned!.label, token: look.token, ...behind, ...BEHIND, says });
    if (run.picture.tracking) {
      const { values } = run.curve("reference", this.#index, trial);
      lines.push({ label: "reference", token: "reference", values, dash: [1.5, 2.5], says });
    }
    const { low, high } = this.#limits;
    if (low) lines.push({ ...LIMIT, values: low.values });
    if (high) lines.push({ ...LIMIT, values: high.values, unlisted: low !== null });
    lines.push({ label: behind ? "now" : symbolOf(port), token: look.token, values: curve.values, dash: look.dash, says });
    return {
      time: curve.time,
      lines,
      measure,
      heading: [capital(motionOf(port)), `${symbolOf(port)} [${measure.unit}]`],
      caption: this.#sentence(scene, port, measure),
    };
  }

  protected override under(plot: uPlot): void {
    if (this.#limits.high) forbid(plot, this.#look, this.#limits.high, 1);
    if (this.#limits.low) forbid(plot, this.#look, this.#limits.low, -1);
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
  #sentence(scene: Scene, port: Port, measure: Measure): string {
    const { run } = scene;
    const trial = trialOf(scene);
    const largest = `Largest ${measure.text(run.largest("y", this.#index, trial))} ${within(trial)}`;
    const limits = (["low", "high"] as const).map((name) => run.curve(name, this.#index, trial).values);
    const [low, high] = limits.map((values) => values[0]!) as [number, number];
    if (low === -Infinity && high === Infinity) return `${largest}; no constraint.`;
    if (limits.some((values) => values.some((value) => value !== values[0]))) return `${largest}; the constraint moves.`;
    const measured = new Measure(Math.max(...[low, high].map(Math.abs).filter(Number.isFinite)), port.motion_unit);
    const range = low === -high ? `±${measured.text(high)}` : `${measured.number(low)} … ${measured.text(high)}`;
    return `${largest}; constraint ${range}${this.#limits.low || this.#limits.high ? "" : " (beyond the plot)"}.`;
  }
}
