// Command and delivered effort of a port against time.

import { Measure } from "../format";
import { capital, effortOf, lookOf } from "../look";
import { BEHIND, type Line } from "../plot/plot";
import { pinnedCurve, type Scene, trialOf } from "../scene";
import type { Hands } from "./panel";
import { type TimeCourse, TimePanel, within } from "./time_panel";

export class Effort extends TimePanel {
  readonly #index: number;

  constructor(hands: Hands, index: number) {
    super(hands, 170);
    this.#index = index;
  }

  protected course(scene: Scene): TimeCourse {
    const { run } = scene;
    const port = run.ports[this.#index]!;
    const { token } = lookOf(run.ports, this.#index);
    const trial = trialOf(scene);
    const delivered = run.curve("delivered", this.#index, trial);
    const command = run.curve("command", this.#index, trial);
    const behind = pinnedCurve(scene, "delivered", port);
    const largest = run.largest("delivered", this.#index, trial);
    const asked = run.largest("command", this.#index, trial);
    const measure = new Measure(Math.max(largest, asked) || 1, port.effort_unit);
    const says = (value: number) => measure.text(value);

    const lines: Line[] = [];
    if (behind) lines.push({ label: `${scene.pinned!.label}, delivered`, token, ...behind, ...BEHIND, says });
    lines.push({ label: "command", token: "faint", values: command.values, dash: [5, 3], width: 1, says });
    lines.push({ label: "delivered", token, values: delivered.values, says });
    return {
      time: delivered.time,
      lines,
      measure,
      heading: [capital(effortOf(port)), `[${measure.unit}]`],
      caption: `Largest ${measure.text(asked)} commanded, ${measure.text(largest)} delivered ${within(trial)}.`,
    };
  }
}
