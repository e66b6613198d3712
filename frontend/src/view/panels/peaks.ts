// What is learned: the largest error of each trial.

import { describe, figure } from "../../dom";
import { quantity } from "../format";
import { capital, lookOf, motionOf } from "../look";
import { BEHIND, type Line, Plot } from "../plot/plot";
import { decades } from "../plot/range";
import { counterpart, type Scene } from "../scene";
import { Card } from "./card";
import type { Hands, Panel } from "./panel";
import { PeaksTable } from "./peaks_table";

export class Peaks implements Panel {
  readonly card: Card;
  readonly #plot: Plot;
  readonly #figure = figure();
  readonly #table = new PeaksTable();

  constructor(hands: Hands) {
    this.#plot = new Plot(this.#figure, {
      look: hands.look,
      height: 190,
      xTitle: "trial",
      log: true,
      whole: true,
      seek: (x) => hands.jump(Math.round(x)),
    });
    this.card = new Card(this.#plot.legend.root);
    this.card.body.append(this.#figure, this.#table.root);
  }

  draw({ run, pinned }: Scene): void {
    const { trials } = run.picture;
    const across = Math.max(trials, pinned?.run.picture.trials ?? 0);
    const lines: Line[] = [];
    run.ports.forEach((port, index) => {
      const look = lookOf(run.ports, index);
      const says = (value: number) => quantity(value, port.motion_unit);
      const other = pinned ? counterpart(pinned, port) : -1;
      if (pinned && other >= 0) {
        const values = Float64Array.from({ length: across }, (_, trial) => pinned.run.peak(trial, other));
        lines.unshift({ label: pinned.label, token: look.token, values, ...BEHIND, marker: look.marker, unlisted: index > 0 });
      }
      const values = Float64Array.from({ length: across }, (_, trial) => run.peak(trial, index));
      lines.push({ label: motionOf(port), token: look.token, values, marker: look.marker, says });
    });
    const x = Float64Array.from({ length: across }, (_, trial) => trial);
    this.#plot.draw(x, lines, { x: [-0.5, across - 0.5], y: decades(lines.map(({ values }) => values)) });
    this.#table.fill(run);

    const units = [...new Set(run.ports.map(({ motion_unit }) => `[${motion_unit}]`))].join(", ");
    this.card.title(run.picture.tracking ? "Largest tracking error of each trial" : "Peak of each trial", units);
    const said = (trial: number, index: number) =>
      `${quantity(run.peak(trial, index), run.ports[index]!.motion_unit)} in trial ${trial}`;
    const sentences = run.ports.map((port, index) => `${motionOf(port)} ${said(0, index)}, ${said(trials - 1, index)}`);
    this.card.caption(trials > 0 ? `${capital(sentences[0] ?? "")}.` : "No trial has been finished.");
    describe(this.#figure, `Peaks on a logarithmic axis against trials. ${sentences.map(capital).join(". ")}.`);
  }

  cursor({ trial }: Scene): void {
    this.#plot.cursor(trial);
  }

  repaint(): void {
    this.#plot.repaint();
  }

  destroy(): void {
    this.#plot.destroy();
  }
}
