// The form of a scenario: sections, a filter, the list of changes, and what the server finds wrong.

import { el, write } from "../dom";
import type { Fault, Picture } from "../protocol";
import { ChangeList } from "./changelist";
import { showFaults } from "./faults";
import { Filter } from "./filter";
import type { Form } from "./form";
import { Section } from "./section";
import { SECTIONS } from "./sections";
import { prose } from "./words";

/** So many sections are open at first. */
const OPEN = 2;

export class ControlsPanel {
  private readonly sections: readonly Section[];
  private readonly folds = el("div", { class: "sections" });
  private readonly filter = new Filter(this.folds);
  private readonly search = el("input", {
    type: "search",
    placeholder: "Find a parameter",
    "aria-label": "Find a parameter",
    autocomplete: "off",
  });
  private readonly found = el("p", { class: "about", role: "status" });
  private readonly faults = el("ul", { class: "faults", "aria-label": "Faults" });
  private readonly changes: ChangeList;
  private readonly only: HTMLButtonElement;
  private faulty = false;
  /** What the last run told. */
  private told = "";

  constructor(
    root: HTMLElement,
    private readonly form: Form,
  ) {
    this.sections = SECTIONS.map((plan, index) => new Section(form, plan, index < OPEN));
    this.folds.append(...this.sections.map((section) => section.element));
    this.changes = new ChangeList(form);
    this.only = el("button", {
      type: "button",
      "aria-pressed": "false",
      onclick: () => this.showOnlyChanges(!this.folds.hidden),
    });
    this.search.addEventListener("input", () => this.sift());
    root.replaceChildren(
      el("div", { class: "finding" }, this.search, this.only),
      this.found,
      this.faults,
      this.changes.element,
      this.folds,
    );
    this.update();
  }

  /** The document has changed. */
  update(): void {
    for (const section of this.sections) section.update();
    this.changes.update();
    const { count } = this.changes;
    write(this.only, count === 0 ? "Changes" : `Changes (${count})`);
    if (this.search.value) this.sift();
  }

  /** What a run tells of its scenario: its ports, and sensible ranges. */
  learn({ ports, sliders }: Picture): void {
    const told = JSON.stringify([ports, sliders]);
    if (told === this.told) return;
    this.told = told;
    this.form.ports = ports;
    this.form.sliders = sliders;
    this.update();
  }

  /** Faults beside their fields, the others in a list at the top; none: everything is in order. */
  show(faults: readonly Fault[]): void {
    if (faults.length === 0 && !this.faulty) return;
    this.faulty = faults.length > 0;
    const homeless = showFaults(this.folds, faults);
    this.faults.replaceChildren(...homeless.map(({ at, text }) => el("li", {}, ...prose(at ? `${at} ${text}` : text))));
    if (faults.length > 0 && homeless.length < faults.length) this.showOnlyChanges(false);
  }

  private showOnlyChanges(only: boolean): void {
    this.only.setAttribute("aria-pressed", String(only));
    this.folds.hidden = only;
    this.changes.show(only);
  }

  private sift(): void {
    this.showOnlyChanges(false);
    const count = this.filter.apply(this.search.value);
    const several = count === 1 ? "1 parameter" : `${count} parameters`;
    write(this.found, count === null ? "" : count === 0 ? "No parameter is called so." : several);
  }
}
