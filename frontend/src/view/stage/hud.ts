// The numbers on the stage: trial, time, and motion and effort of every port.

import type { Port } from "../../protocol";
import type { Run } from "../../run";
import { el, write } from "../../dom";
import { Measure, number } from "../format";
import { effortOf, lookOf, symbolOf } from "../look";
import type { Scene } from "../scene";

interface Row {
  motion: HTMLElement;
  effort: HTMLElement;
}

export class Hud {
  readonly root = el("div", { class: "hud" });
  readonly #name = el("p", { class: "hud-name" });
  readonly #trial = el("p", { class: "hud-trial" });
  readonly #time = el("p", { class: "hud-time" });
  readonly #note = el("p", { class: "hud-note" });
  readonly #table = el("table", { class: "hud-ports" });
  #rows: Row[] = [];
  #run: Run | null = null;
  #measured = -1; // the trial that the measures are for
  #motions: Measure[] = [];
  #efforts: Measure[] = [];

  constructor() {
    this.root.append(this.#name, el("div", {}, this.#trial, this.#time, this.#note), this.#table);
  }

  name(text: string): void {
    write(this.#name, text);
    this.#name.title = text;
  }

  show({ run, trial, time }: Scene, note: string): void {
    if (this.#run !== run) this.#list(run);
    if (this.#measured !== trial) this.#measure(run, trial);
    write(this.#trial, `Trial ${trial} of ${run.picture.trials}`);
    write(this.#time, `t = ${time.toFixed(run.picture.duration < 0.1 ? 5 : 3)} s`);
    write(this.#note, note);
    const detail = run.trial(trial);
    this.#rows.forEach((row, index) => {
      write(row.motion, detail ? this.#motions[index]!.text(detail.at("y", index, time)) : "…");
      write(row.effort, detail ? this.#efforts[index]!.text(detail.at("delivered", index, time)) : "…");
    });
  }

  #list(run: Run): void {
    this.#run = run;
    this.#measured = -1;
    this.#rows = run.ports.map(() => ({ motion: el("td", {}), effort: el("td", {}) }));
    this.#table.replaceChildren(
      el("caption", { class: "unseen" }, "Motion and delivered effort at the moment"),
      el("tbody", {}, ...run.ports.map((port, index) => this.#row(run, port, index))),
    );
  }

  /** Units and decimals for one trial, so that numbers keep their form while it plays. */
  #measure(run: Run, trial: number): void {
    this.#measured = trial;
    this.#motions = run.ports.map((port, index) => new Measure(run.largest("y", index, trial), port.motion_unit));
    this.#efforts = run.ports.map((port, index) => new Measure(run.largest("delivered", index, trial), port.effort_unit));
  }

  #row(run: Run, port: Port, index: number): HTMLElement {
    const { motion, effort } = this.#rows[index]!;
    const key = el("span", { class: "key" });
    key.style.background = `var(--${lookOf(run.ports, index).token})`;
    return el(
      "tr",
      {},
      el("th", { scope: "row" }, key, symbolOf(port)),
      motion,
      el("th", { scope: "row" }, effortOf(port)),
      effort,
    );
  }
}

/** "deflection × 4" */
export function timesText(factor: number): string {
  return `deflection × ${number(factor, factor < 10 ? 2 : 3).replace(/\.0+$/, "")}`;
}
