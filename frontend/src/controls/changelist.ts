// What differs from the preset, line by line, each with its way back.

import { type Change, changes, inBrief } from "../changes";
import { el } from "../dom";
import { formatPath } from "../path";
import type { Value } from "../protocol";
import type { Form } from "./form";

export class ChangeList {
  readonly element = el("div", { class: "changes", hidden: true });
  private count_ = 0;

  constructor(private readonly form: Form) {}

  get count(): number {
    return this.count_;
  }

  update(): void {
    const { scenario } = this.form;
    const found = changes(scenario.preset.table, scenario.table);
    this.count_ = found.length;
    if (this.element.hidden) return;
    const none = el("p", { class: "about" }, `Nothing differs from ${scenario.preset.name}.`);
    this.element.replaceChildren(found.length === 0 ? none : el("ul", {}, ...found.map((change) => this.line(change))));
  }

  show(shown: boolean): void {
    this.element.hidden = !shown;
    this.update();
  }

  private line({ path, before, after }: Change): HTMLElement {
    const at = formatPath(path);
    return el(
      "li",
      {},
      el("code", {}, at),
      el("span", { class: "values" }, el("del", {}, short(before)), " → ", el("ins", {}, short(after))),
      el(
        "button",
        { type: "button", class: "quiet", "aria-label": `Revert ${at}`, onclick: () => this.form.scenario.revert(path) },
        "revert",
      ),
    );
  }
}

const LONGEST = 60; // characters: enough for a few numbers, or for the kind that a table is of

function short(value: Value | undefined): string {
  const text = inBrief(value);
  return text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
}
