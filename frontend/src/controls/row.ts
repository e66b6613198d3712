// The frame of a field: its name, unit, help, error, the mark of a change, and the way back to the default.

import { el, freshId, write } from "../dom";
import { prettyUnit } from "../numbers";
import { equal, formatPath, type Path } from "../path";
import type { Described, Form } from "./form";
import { describe, isEmpty, plain, prose } from "./words";

export class Row {
  readonly element: HTMLElement;
  readonly body = el("div", { class: "entry" });
  private readonly id = freshId();
  private readonly at: string;
  private readonly mark = el("span", { class: "mark", hidden: true }, el("span", { class: "unseen" }, "changed from the preset"));
  private readonly error: HTMLElement;
  private readonly reset: HTMLButtonElement;

  /** `group`: the body holds several controls, so that the name is not one control's label. */
  constructor(
    private readonly form: Form,
    private readonly path: Path,
    private readonly parameter: Described,
    private readonly group = false,
  ) {
    this.at = formatPath(path);
    this.error = el("p", { class: "error", id: `${this.id}-error`, "data-error": this.at });
    const name = group
      ? el("span", { class: "name", id: `${this.id}-name` }, parameter.name)
      : el("label", { class: "name", for: this.id }, parameter.name);
    const help = el("p", { class: "help", id: `${this.id}-help` }, ...prose(describe(parameter)));
    this.reset = el("button", { type: "button", class: "quiet", hidden: true, onclick: () => form.scenario.remove(path) });
    this.element = el(
      "div",
      { class: "field", "data-at": this.at, "data-words": `${this.at} ${parameter.doc}`.toLowerCase() },
      el(
        "div",
        { class: "naming" },
        name,
        this.mark,
        el("span", { class: "unit" }, prettyUnit(parameter.unit)),
        // The description says it in full.
        el("span", { class: "brief", "aria-hidden": "true" }, plain(parameter.doc)),
        this.reset,
        ...(parameter.doc ? [helpButton(parameter.name, help)] : []),
      ),
      this.body,
      help,
      this.error,
    );
    if (group) {
      this.element.setAttribute("role", "group");
      this.element.setAttribute("aria-labelledby", `${this.id}-name`);
      this.element.setAttribute("aria-describedby", this.descriptions);
    }
  }

  /** Attributes of the control that this row is about. */
  get control() {
    const { id, at } = this;
    return { id, "data-path": at, "aria-describedby": this.descriptions, autocomplete: "off", spellcheck: "false" };
  }

  /** Attributes of a slider beside that control. */
  get slider() {
    return { "data-slider": this.at, "aria-label": `${this.parameter.name}, slider`, "aria-describedby": this.descriptions };
  }

  update(): void {
    const { form, path, parameter } = this;
    this.mark.hidden = !form.scenario.differs(path);
    const value = form.scenario.value(path);
    this.reset.hidden = parameter.required || value === undefined || equal(value, parameter.default);
    const back = isEmpty(parameter.default) ? "leave out" : "default";
    write(this.reset, back);
    const label = back === "default" ? `${parameter.name}: back to the default` : `${parameter.name}: leave out`;
    this.reset.setAttribute("aria-label", label);
  }

  /** A fault of what was typed, before anything has been sent; "" when it is mended. */
  fail(text: string): void {
    const shown = "typed" in this.error.dataset;
    if (!text && !shown) return;
    this.error.toggleAttribute("data-typed", text !== "");
    write(this.error, text);
    if (!this.group) this.body.querySelector(`#${this.id}`)?.setAttribute("aria-invalid", String(text !== ""));
  }

  private get descriptions(): string {
    return `${this.id}-help ${this.id}-error`;
  }
}

/** A "?" that shows and hides a help text; the text describes its control in either case. */
export function helpButton(about: string, help: HTMLElement): HTMLButtonElement {
  const button = el(
    "button",
    { type: "button", class: "ask", "aria-label": `What is ${about}?`, "aria-expanded": "false", "aria-controls": help.id },
    "?",
  );
  button.addEventListener("click", () => {
    const open = button.getAttribute("aria-expanded") !== "true";
    button.setAttribute("aria-expanded", String(open));
    help.classList.toggle("open", open);
  });
  return button;
}
