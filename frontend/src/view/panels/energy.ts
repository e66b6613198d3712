// Energy of the structure and of the barrier against time, and the account of the whole run.

import { Measure } from "../format";
import { BEHIND, type Line } from "../plot/plot";
import { extent } from "../plot/range";
import { pinnedCurve, type Scene, trialOf } from "../scene";
import { EnergyAccount } from "./energy_account";
import type { Hands } from "./panel";
import { type TimeCourse, TimePanel, within } from "./time_panel";

const ROOM = 0.04; // below zero, as a share of the height

export class Energy extends TimePanel {
  readonly #account: EnergyAccount;

  constructor(hands: Hands, account = new EnergyAccount()) {
    super(hands, 160, account.root);
    this.#account = account;
  }

  protected course(scene: Scene): TimeCourse {
    const { run } = scene;
    const trial = trialOf(scene);
    const curve = run.curve("energy", 0, trial);
    const behind = pinnedCurve(scene, "energy", null);
    const largest = run.largest("energy", 0, trial);
    const measure = new Measure(largest || 1, "J");
    const says = (value: number) => measure.text(value);
    this.#account.fill(run.picture.energy, scene.pinned);

    const lines: Line[] = [];
    if (behind) lines.push({ label: scene.pinned!.label, token: "ink", ...behind, ...BEHIND, says });
    lines.push({ label: behind ? "structure, now" : "structure", token: "ink", values: curve.values, says });
    const detail = trial === null ? null : run.trial(trial);
    if (detail) lines.push({ label: "barrier", token: "constraint", values: detail.column("barrier", 0), dash: [6, 4], says });
    const [, high] = extent(lines.map(({ values }) => values));
    return {
      time: curve.time,
      lines,
      measure,
      y: [-ROOM * high, high],
      heading: ["Energy", `[${measure.unit}]`],
      caption: `Largest ${measure.text(largest)} ${within(trial)}.`,
    };
  }
}
