// Command and delivered effort of a port against time.

import { describe, figure } from "../../dom";
import { Measure } from "../format";
import { capital, effortOf, lookOf } from "../look";
import { tickTrials } from "../plot/paint";
import { BEHIND, type Line, Plot } from "../plot/plot";
import { extent } from "../plot/range";
import { cursorOf, endOf, pinnedCurve, type Scene, trialOf } from "../scene";
import { Card } from "./card";
import type { Hands, Panel } from "./panel";

export class Effort implements Panel {
  readonly card: Card;
  readonly #plot: Plot;
  readonly #figure = figure();
  readonly #index: number;
  #borders = 0;
  #duration = 1;

  constructor(hands: Hands, index: number) {
    this.#index = index;
    this.#plot = new Plot(this.#figure, {
      look: hands.look,
      height: 170,
      xTitle: "time t [s]",
      seek: hands.seek,
      under: (plot) => tickTrials(plot, hands.look, this.#borders, this.#duration),
    });
    this.card = new Card(this.#plot.legend.root);
    this.card.body.append(this.#figure);
  }

  draw(scene: Scene): void {
    const { run } = scene;
    const port = run.ports[this.#index]!;
    const { token } = lookOf(run.ports, this.#index);
    const trial = trialOf(scene);
    const delivered = run.curve("delivered", this.#index, trial);
    const command = run.curve("command", this.#index, trial);
    const behind = pinnedCurve(scene, "delivered", port, delivered);
    const largest = run.largest("delivered", this.#index, trial);
    const asked = run.largest("command", this.#index, trial);
    const measure = new Measure(Math.max(largest, asked) || 1, port.effort_unit);
    const says = (value: number) => measure.text(value);
    this.#borders = trial === null ? run.picture.trials : 0;
    this.#duration = run.picture.duration;

    const lines: Line[] = [];
    if (behind) lines.push({ label: `${scene.pinned!.label}, delivered`, token, values: behind, ...BEHIND, says });
    lines.push({ label: "command", token: "faint", values: command.values, dash: [5, 3], width: 1, says });
    lines.push({ label: "delivered", token, values: delivered.values, says });
    this.#plot.draw(delivered.time, lines, {
      x: [0, endOf(scene)],
      y: extent(lines.map(({ values }) => values)),
      factor: measure.factor,
    });

    this.card.title(capital(effortOf(port)), `[${measure.unit}]`);
    const caption = `Largest ${measure.text(asked)} commanded, ${measure.text(largest)} delivered ${trial === null ? "in all trials" : `in trial ${trial}`}.`;
    this.card.caption(caption);
    describe(this.#figure, `${capital(effortOf(port))} against time. ${caption}`);
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
}
