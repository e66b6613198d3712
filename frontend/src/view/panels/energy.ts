// Energy of the structure and of the barrier against time, and the account of the whole run.

import { describe, figure } from "../../dom";
import { Measure } from "../format";
import { tickTrials } from "../plot/paint";
import { BEHIND, type Line, Plot } from "../plot/plot";
import { extent } from "../plot/range";
import { cursorOf, endOf, pinnedCurve, type Scene, trialOf } from "../scene";
import { Card } from "./card";
import { EnergyAccount } from "./energy_account";
import type { Hands, Panel } from "./panel";

export class Energy implements Panel {
  readonly card: Card;
  readonly #plot: Plot;
  readonly #figure = figure();
  readonly #account = new EnergyAccount();
  #borders = 0;
  #duration = 1;

  constructor(hands: Hands) {
    this.#plot = new Plot(this.#figure, {
      look: hands.look,
      height: 160,
      xTitle: "time t [s]",
      seek: hands.seek,
      under: (plot) => tickTrials(plot, hands.look, this.#borders, this.#duration),
    });
    this.card = new Card(this.#plot.legend.root);
    this.card.body.append(this.#figure, this.#account.root);
  }

  draw(scene: Scene): void {
    const { run } = scene;
    const trial = trialOf(scene);
    const curve = run.curve("energy", 0, trial);
    const behind = pinnedCurve(scene, "energy", null, curve);
    const largest = run.largest("energy", 0, trial);
    const measure = new Measure(largest || 1, "J");
    const says = (value: number) => measure.text(value);
    this.#borders = trial === null ? run.picture.trials : 0;
    this.#duration = run.picture.duration;

    const lines: Line[] = [];
    if (behind) lines.push({ label: scene.pinned!.label, token: "ink", values: behind, ...BEHIND, says });
    lines.push({ label: behind ? "structure, now" : "structure", token: "ink", values: curve.values, says });
    const detail = trial === null ? null : run.trial(trial);
    if (detail) lines.push({ label: "barrier", token: "constraint", values: detail.column("barrier", 0), dash: [6, 4], says });
    const [, high] = extent(lines.map(({ values }) => values));
    this.#plot.draw(curve.time, lines, { x: [0, endOf(scene)], y: [-0.04 * high, high], factor: measure.factor });
    this.#account.fill(run.picture.energy, scene.pinned);

    this.card.title("Energy", `[${measure.unit}]`);
    const caption = `Largest ${measure.text(largest)} ${trial === null ? "in all trials" : `in trial ${trial}`}.`;
    this.card.caption(caption);
    describe(this.#figure, `Energy of the structure against time. ${caption}`);
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
