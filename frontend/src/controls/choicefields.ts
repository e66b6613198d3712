// What is chosen: one of several words, yes or no, a file.

import { el, write } from "../dom";
import { formatPath, type Path } from "../path";
import { Refused } from "../server";
import type { Described, Field, Form } from "./form";
import { Row } from "./row";

/** The value of the option that stands for "not set". */
const UNSET = "";

export class ChoiceField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly select: HTMLSelectElement;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
    choices: readonly string[],
  ) {
    this.row = new Row(form, path, parameter);
    this.element = this.row.element;
    const { required, default: standard } = parameter;
    const unset = required ? "needed" : standard === undefined ? "left out" : `${String(standard)} (default)`;
    const options = choices.map((choice) => el("option", { value: choice }, choice));
    this.select = el("select", this.row.control, el("option", { value: UNSET }, unset), ...options);
    this.select.addEventListener("change", () => {
      if (this.select.value === UNSET) form.scenario.remove(path);
      else form.scenario.set(path, this.select.value);
    });
    this.row.body.append(this.select);
    this.update();
  }

  update(): void {
    this.row.update();
    const given = this.form.scenario.value(this.path);
    this.select.value = given === undefined ? UNSET : String(given);
  }
}

export class SwitchField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly input: HTMLInputElement;
  private readonly word = el("span", { class: "word", "aria-hidden": "true" });

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    private readonly parameter: Described,
  ) {
    this.row = new Row(form, path, parameter);
    this.element = this.row.element;
    this.input = el("input", { type: "checkbox", role: "switch", ...this.row.control });
    this.input.addEventListener("change", () => form.scenario.set(path, this.input.checked));
    this.row.body.append(this.input, this.word);
    this.update();
  }

  update(): void {
    this.row.update();
    this.input.checked = (this.form.scenario.value(this.path) ?? this.parameter.default) === true;
    write(this.word, this.input.checked ? "yes" : "no");
  }
}

export class FileField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly name = el("output", { class: "file" });

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
  ) {
    this.row = new Row(form, path, parameter);
    this.element = this.row.element;
    const input = el("input", { type: "file", ...this.row.control, onchange: () => void this.take(input) });
    this.row.body.append(this.name, input);
    this.update();
  }

  update(): void {
    this.row.update();
    write(this.name, String(this.form.scenario.value(this.path) ?? "no file yet"));
  }

  private async take(input: HTMLInputElement): Promise<void> {
    const [file] = input.files ?? [];
    if (!file) return;
    this.row.fail("");
    try {
      this.form.scenario.set(this.path, await this.form.attach(file));
    } catch (error) {
      this.row.fail(error instanceof Refused ? error.message : "The file did not reach the server.");
    }
    input.value = "";
  }
}

/** Code never comes from a browser; what the scenario file says of it is shown. */
export class CodeField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly input: HTMLInputElement;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    parameter: Described,
  ) {
    this.row = new Row(form, path, parameter);
    this.element = this.row.element;
    const placeholder = "code of your own: edit the scenario file";
    this.input = el("input", { type: "text", disabled: true, placeholder, ...this.row.control });
    this.row.body.append(this.input);
    this.update();
  }

  update(): void {
    this.row.update();
    const given = this.form.scenario.value(this.path);
    this.input.value = given === undefined ? "" : String(given);
    this.input.title = formatPath(this.path);
  }
}
