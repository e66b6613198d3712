// What all plots against time have in common: one axis, one cursor, and in the whole run a tick where a trial begins.

import type uPlot from "uplot";
import { describe, figure } from "../../dom";
import type { Measure } from "../format";
import { tickTrials } from "../plot/paint";
import { type Line, Plot } from "../plot/plot";
import { extent } from "../plot/range";
import { cursorOf, endOf, type Scene, trialOf } from "../scene";
import { Card } from "./card";
import type { Hands, Panel } from "./panel";

export interface TimeCourse {
  time: Float64Array;
  lines: Line[];
  measure: Measure;
  y?: [number, number]; // left out: what the lines need
  heading: [string, string]; // words, and symbol and unit
  caption: string;
}

export abstract class TimePanel implements Panel {
  readonly card: Card;
  readonly #plot: Plot;
  readonly #figure = figure();
  #trials = 0; // how many have borders to be ticked
  #duration = 1;

  constructor(hands: Hands, height: number, ...below: HTMLElement[]) {
    this.#plot = new Plot(this.#figure, {
      look: hands.look,
      height,
      xTitle: "time t [s]",
      seek: hands.seek,
      under: (plot) => {
        this.under(plot);
        tickTrials(plot, hands.look, this.#trials, this.#duration);
      },
    });
    this.card = new Card(this.#plot.legend.root);
    this.card.body.append(this.#figure, ...below);
  }

  draw(scene: Scene): void {
    const { time, lines, measure, y, heading, caption } = this.course(scene);
    this.#trials = trialOf(scene) === null ? scene.run.picture.trials : 0;
    this.#duration = scene.run.picture.duration;
    const range = y ?? extent(lines.map(({ values }) => values));
    this.#plot.draw(time, lines, { x: [0, endOf(scene)], y: range, factor: measure.factor });
    this.card.title(...heading);
    this.card.caption(caption);
    describe(this.#figure, `${heading[0]} against time. ${caption}`);
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

  /** What is to be drawn of a scene. */
  protected abstract course(scene: Scene): TimeCourse;

  /** Painted before the lines. */
  protected under(_: uPlot): void {}
}

/** "in trial 3", "in all trials" */
export const within = (trial: number | null): string => (trial === null ? "in all trials" : `in trial ${trial}`);
