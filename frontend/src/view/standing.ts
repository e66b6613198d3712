// How the run that is drawn stands to the scenario that is worked on, and how the page shows that.

/** It is the scenario's own; the scenario's own is still to come; or the scenario has none, and the one drawn is another's. */
export type Standing = "own" | "coming" | "other";

const PATIENCE = 200; // until a run that is to come is waited for visibly [ms]; most come before

export class Mark {
  readonly #sections: readonly HTMLElement[];
  readonly #name: (text: string) => void;
  #timer = 0;

  /** `name`: takes what is to be said of the run where it is named. */
  constructor(sections: readonly HTMLElement[], name: (text: string) => void) {
    this.#sections = sections;
    this.#name = name;
  }

  /** `label`: the run that is drawn, "" for none. `fresh`: whether it has been drawn just now. */
  show(standing: Standing, label: string, fresh: boolean): void {
    clearTimeout(this.#timer);
    for (const section of this.#sections) section.setAttribute("aria-busy", String(standing === "coming"));
    if (fresh || standing === "own") this.#stale("", label);
    if (label === "") return;
    if (standing === "other") this.#stale(`Not this scenario: last run of ${label}`, `not this scenario: last run of ${label}`);
    if (standing === "coming")
      this.#timer = window.setTimeout(() => this.#stale("Being worked out …", `last run: ${label}`), PATIENCE);
  }

  #stale(word: string, name: string): void {
    for (const section of this.#sections) {
      if (word) section.dataset["stale"] = word;
      else delete section.dataset["stale"];
    }
    this.#name(name);
  }
}
