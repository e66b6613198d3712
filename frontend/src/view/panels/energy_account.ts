// Where the energy of the whole run came from and where it went, as a table that must close.

import { el } from "../../dom";
import { Measure, number } from "../format";
import type { Picture } from "../../protocol";
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

type Account = Picture["energy"];

export class EnergyAccount {
  readonly root = el("details", { class: "account", open: true }, el("summary", {}, "Account of the whole run"));
  readonly #body = el("tbody", {});
  readonly #closing = el("p", { class: "account-closing" });

  constructor() {
    this.root.append(el("table", {}, el("caption", { class: "unseen" }, "Energy account"), this.#body), this.#closing);
  }

  fill(energy: Account, pinned: Pinned | null): void {
    const largest = Math.max(...ENTRIES.map(([key]) => Math.abs(energy[key] ?? 0)));
    const measure = new Measure(largest, "J");
    const said = (of: Account, key: string) => {
      if (of[key] === null) return "–";
      const value = (TAKEN.has(key) ? -1 : 1) * (of[key] ?? 0);
      return ALWAYS.has(key) && (key === "initial" || key === "final")
        ? measure.text(value)
        : `${value > 0 ? "+" : ""}${measure.text(value)}`;
    };
    const told = (of: Account | undefined, key: string) => of?.[key] === null || Boolean(of?.[key]);
    const rows = ENTRIES.filter(([key]) => ALWAYS.has(key) || told(energy, key) || told(pinned?.run.picture.energy, key));
    this.#body.replaceChildren(
      ...(pinned
        ? [el("tr", {}, el("td", {}), el("th", { scope: "col" }, "now"), el("th", { scope: "col" }, pinned.label))]
        : []),
      ...rows.map(([key, words]) =>
        el(
          "tr",
          { class: key === "final" ? "total" : "" },
          el("th", { scope: "row" }, words),
          el("td", {}, said(energy, key)),
          ...(pinned ? [el("td", {}, said(pinned.run.picture.energy, key))] : []),
        ),
      ),
    );
    const error = energy["error"];
    this.#closing.textContent =
      error === undefined ? "" : `The account closes to ${number(error ?? NaN, 2)} of the largest energy.`;
  }
}
