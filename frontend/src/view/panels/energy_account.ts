// Where the energy of the whole run came from and where it went, as a table that must close.

import { make } from "../dom";
import { Measure, number } from "../format";
import type { Pinned } from "../scene";

const ENTRIES: [string, string][] = [
  ["initial", "at the start"],
  ["law", "by the control law"],
  ["actuator", "by the actuators' error"],
  ["disturbance", "by disturbances"],
  ["load", "by the distributed load"],
  ["dissipated", "damped away"],
  ["resets", "by the resets between trials"],
  ["final", "at the end"],
];
const ALWAYS = new Set(["initial", "law", "final"]);
const TAKEN = new Set(["dissipated"]); // written as what leaves

export class EnergyAccount {
  readonly root = make("details", { class: "account", open: true }, make("summary", {}, "Account of the whole run"));
  readonly #body = make("tbody", {});
  readonly #closing = make("p", { class: "account-closing" });

  constructor() {
    this.root.append(make("table", {}, make("caption", { class: "unseen" }, "Energy account"), this.#body), this.#closing);
  }

  fill(energy: { [name: string]: number }, pinned: Pinned | null): void {
    const largest = Math.max(...ENTRIES.map(([key]) => Math.abs(energy[key] ?? 0)));
    const measure = new Measure(largest, "J");
    const said = (of: { [name: string]: number }, key: string) => {
      const value = (TAKEN.has(key) ? -1 : 1) * (of[key] ?? 0);
      return ALWAYS.has(key) && (key === "initial" || key === "final") ? measure.text(value) : `${value > 0 ? "+" : ""}${measure.text(value)}`;
    };
    const rows = ENTRIES.filter(([key]) => ALWAYS.has(key) || energy[key] || pinned?.run.picture.energy[key]);
    this.#body.replaceChildren(
      ...(pinned ? [make("tr", {}, make("td", {}), make("th", { scope: "col" }, "now"), make("th", { scope: "col" }, pinned.label))] : []),
      ...rows.map(([key, words]) =>
        make(
          "tr",
          { class: key === "final" ? "total" : "" },
          make("th", { scope: "row" }, words),
          make("td", {}, said(energy, key)),
          ...(pinned ? [make("td", {}, said(pinned.run.picture.energy, key))] : []),
        ),
      ),
    );
    const error = energy["error"];
    this.#closing.textContent = error === undefined ? "" : `The account closes to ${number(error, 2)} of the largest energy.`;
  }
}
