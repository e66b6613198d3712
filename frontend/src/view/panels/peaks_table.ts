// The peaks as a table, for those who do not see the plot.

import type { Run } from "../../run";
import { el, write } from "../../dom";
import { quantity } from "../format";
import { motionOf } from "../look";

const MANY = 500; // trials, beyond which not each has a row

export class PeaksTable {
  readonly root = el("div", { class: "unseen" });
  #cells: { cell: HTMLTableCellElement; trial: number; port: number }[] = [];
  #made = "";

  fill(run: Run): void {
    const { trials, ports } = run.picture;
    const wanted = [trials, ...ports.map(({ name }) => name)].join();
    if (wanted !== this.#made) {
      this.#made = wanted;
      this.#el(run);
    }
    this.#cells.forEach(({ cell, trial, port }) => {
      const value = run.peak(trial, port);
      cell.dataset["value"] = String(value);
      write(cell, quantity(value, ports[port]!.motion_unit));
    });
  }

  #el({ picture: { trials, ports } }: Run): void {
    this.#cells = [];
    const head = el(
      "tr",
      {},
      el("th", { scope: "col" }, "Trial"),
      ...ports.map((port) => el("th", { scope: "col" }, `Largest ${motionOf(port)}`)),
    );
    const every = Math.ceil(trials / MANY);
    const listed = Array.from({ length: Math.ceil(trials / every) || 0 }, (_, row) => row * every);
    if (trials > 0 && listed.at(-1) !== trials - 1) listed.push(trials - 1);
    const rows = listed.map((trial) => {
      const cells = ports.map((port) => el("td", { "data-port": port.name, "data-trial": String(trial) }));
      this.#cells.push(...cells.map((cell, port) => ({ cell, trial, port })));
      return el("tr", {}, el("th", { scope: "row" }, String(trial)), ...cells);
    });
    const caption = el("caption", {}, every > 1 ? `Peaks of one trial in ${every}, and of the last` : "Peaks of every trial");
    this.root.replaceChildren(el("table", { "data-role": "peaks" }, caption, el("thead", {}, head), el("tbody", {}, ...rows)));
  }
}
