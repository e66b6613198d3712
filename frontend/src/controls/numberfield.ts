// A number: typed, or moved by a slider.

import { el } from "../dom";
import { parseNumber, prettyUnit, readable } from "../numbers";
import { formatPath, type Path } from "../path";
import type { Described, Field, Form } from "./form";
import { Row } from "./row";
import { holds, inside, numberAt, positionOf, type Scale, scaleFor, TRAVEL } from "./scale";
import { onTyped } from "./typed";

export class NumberField implements Field {
  readonly element: HTMLElement;
  private readonly row: Row;
  private readonly input: HTMLInputElement;
  private readonly slider: HTMLInputElement;
  private readonly at: string;
  private scale: Scale | null = null;

  constructor(
    private readonly form: Form,
    private readonly path: Path,
    private readonly parameter: Described,
  ) {
    this.at = formatPath(path);
    this.row = new Row(form, path, parameter);
    this.element = this.row.element;
    this.slider = el("input", { type: "range", min: 0, max: TRAVEL, step: 1, hidden: true, ...this.row.slider });
    this.input = el("input", {
      type: "text",
      // The keyboards for decimals on telephones have no minus sign.
      inputmode: (parameter.range.ge ?? parameter.range.gt ?? -1) >= 0 ? "decimal" : "text",
      placeholder: this.placeholder,
      "aria-required": parameter.required ? "true" : undefined,
      ...this.row.control,
    });
    this.row.body.append(this.slider, this.input);
    this.slider.addEventListener("input", () => this.slide());
    this.slider.addEventListener("change", () => form.scenario.settle());
    onTyped(
      this.input,
      () => this.typed(),
      () => form.scenario.settle(),
    );
    this.update();
  }

  update(): void {
    const given = this.form.scenario.value(this.path);
    this.row.update();
    this.show(given);
    const value = given ?? this.parameter.default;
    const number = typeof value === "number" ? value : undefined;
    if (document.activeElement !== this.slider || !this.holds(number)) this.rescale(number);
    this.slider.hidden = this.scale === null;
    this.slider.classList.toggle("unset", given === undefined);
    if (!this.scale || number === undefined) return;
    // The hand is ahead of the rounded value: leave the slider where the hand has put it.
    if (numberAt(this.scale, Number(this.slider.value)) !== number) this.slider.value = String(positionOf(this.scale, number));
    this.slider.setAttribute("aria-valuetext", `${readable(number)} ${prettyUnit(this.parameter.unit)}`.trim());
  }

  private get placeholder(): string {
    const { required, default: standard } = this.parameter;
    if (required) return "needed";
    return typeof standard === "number" ? readable(standard) : "left out";
  }

  private show(given: unknown): void {
    const text = given === undefined ? "" : String(given);
    // What is being typed stays as it is while it means the same, so that "0.50" is not cut to "0.5" under the cursor.
    if (this.input.value !== text && (text === "" || parseNumber(this.input.value) !== given)) {
      this.input.value = text;
      this.row.fail("");
    }
  }

  /** Keeps the scale as long as it will do, so that nothing moves under the hand. */
  private rescale(number: number | undefined): void {
    const found = this.form.sliders[this.at];
    if (found && number !== undefined && found.low <= number && number <= found.high) {
      this.scale = inside({ ...found, whole: this.parameter.type.is === "integer" }, this.parameter.range);
    } else if (!this.holds(number)) {
      this.scale = scaleFor(number, this.parameter);
    }
  }

  private holds(number: number | undefined): boolean {
    return this.scale !== null && (number === undefined || holds(this.scale, number));
  }

  private slide(): void {
    if (this.scale) this.form.scenario.set(this.path, numberAt(this.scale, Number(this.slider.value)), `slide ${this.at}`);
  }

  private typed(): void {
    if (this.input.value.trim() === "") {
      this.row.fail("");
      this.form.scenario.remove(this.path);
      return;
    }
    const number = parseNumber(this.input.value);
    const whole = this.parameter.type.is === "integer";
    if (number === undefined) return this.row.fail("This is not a number.");
    if (whole && !Number.isInteger(number)) return this.row.fail("This must be a whole number.");
    // Beyond it the page would run another number than the one that was typed.
    if (whole && !Number.isSafeInteger(number)) return this.row.fail("This whole number is too large.");
    this.row.fail("");
    if (!this.form.sliders[this.at]) this.scale = scaleFor(number, this.parameter);
    this.form.scenario.set(this.path, number, `type ${this.at}`);
    return undefined;
  }
}
