// One section of the form: a heading that folds, with the mark of a change and the kind in use.

import { el, write } from "../dom";
import { isTable } from "../path";
import type { Field, Form } from "./form";
import type { SectionPlan } from "./sections";
import { prose } from "./words";

export class Section implements Field {
  readonly element: HTMLElement;
  private readonly details: HTMLDetailsElement;
  private readonly add: HTMLButtonElement;
  private readonly gist = el("span", { class: "gist" });
  private readonly mark = el("span", { class: "mark", hidden: true }, el("span", { class: "unseen" }, "changed from the preset"));
  private readonly remark = el("p", { class: "about" });
  private readonly field: Field;
  private wanted: boolean;

  constructor(
    private readonly form: Form,
    private readonly plan: SectionPlan,
    open: boolean,
  ) {
    const { key, title } = plan;
    this.wanted = !plan.onDemand;
    this.field = plan.make(form);
    this.add = el("button", { type: "button", class: "add", onclick: () => this.unfold() }, `Add ${title.toLowerCase()}`);
    this.details = el(
      "details",
      { class: "section", "data-group": "", "data-section": key, open },
      el("summary", {}, el("h2", {}, title), this.mark, this.gist),
      el("p", { class: "about" }, ...prose(form.schema.tables[key]?.summary ?? "")),
      this.remark,
      el("p", { class: "error", "data-error": key }),
      this.field.element,
    );
    this.element = el("div", {}, this.add, this.details);
    this.update();
  }

  update(): void {
    const { form, plan } = this;
    const value = form.scenario.value([plan.key]);
    const there = this.wanted || value !== undefined;
    this.details.hidden = !there;
    this.add.hidden = there;
    this.mark.hidden = !form.scenario.differs([plan.key]);
    write(this.gist, isTable(value) && typeof value.kind === "string" ? value.kind : "");
    write(this.remark, plan.remark?.(form.scenario.table) ?? "");
    this.field.update();
  }

  private unfold(): void {
    this.wanted = true;
    this.update();
    this.details.open = true;
    this.details.querySelector("summary")?.focus();
  }
}
