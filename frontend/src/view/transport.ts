// The controls of time: play, step, scrub, speed, trial and span.

import { el, write } from "../dom";
import { cursorOf, endOf, type Scene, type Span } from "./scene";
import { icon } from "./icons";

export interface TransportEvents {
  play(playing: boolean): void;
  step(by: 1 | -1): void;
  seek(time: number): void; // on the time axis of the panels [s]
  jump(trial: number): void;
  speed(speed: number): void;
  span(span: Span): void;
}

const SPEEDS: [number, string][] = [
  [1 / 50, "1/50"],
  [1 / 20, "1/20"],
  [1 / 10, "1/10"],
  [1 / 4, "1/4"],
  [1 / 2, "1/2"],
  [1, "1"],
  [2, "2"],
];

export class Transport {
  readonly #play: HTMLButtonElement;
  readonly #scrub = el("input", { type: "range", min: "0", step: "any", class: "scrub", "aria-label": "Time" });
  readonly #time = el("span", { class: "time" });
  readonly #speed = el(
    "select",
    { "aria-label": "Speed" }, // the word beside it is not seen on a telephone
    ...SPEEDS.map(([value, text]) => el("option", { value: String(value) }, `${text} × real time`)),
  );
  readonly #trial = el("input", { type: "range", min: "0", step: "1", "aria-label": "Trial" });
  readonly #number = el("input", { type: "number", min: "0", step: "1", "aria-label": "Number of the trial" });
  readonly #count = el("span", { class: "faint" });
  readonly #spans: { [span in Span]: HTMLInputElement };

  constructor(root: HTMLElement, events: TransportEvents) {
    this.#play = icon("play", "Play (space)", () => events.play(this.#play.dataset["playing"] !== "true"));
    this.#scrub.oninput = () => events.seek(Number(this.#scrub.value));
    this.#speed.onchange = () => events.speed(Number(this.#speed.value));
    this.#trial.oninput = () => events.jump(Number(this.#trial.value));
    this.#number.onchange = () => events.jump(Number(this.#number.value));
    const by = (trials: number) => () => events.jump(Number(this.#trial.value) + trials);
    const span = (value: Span) => el("input", { type: "radio", name: "span", value, onchange: () => events.span(value) });
    this.#spans = { trial: span("trial"), run: span("run") };

    const rows = el("div", { class: "transport" });
    root.append(rows);
    rows.append(
      el(
        "div",
        { class: "transport-row" },
        icon("back", "A snapshot back (,)", () => events.step(-1)),
        this.#play,
        icon("on", "A snapshot on (.)", () => events.step(1)),
        this.#scrub,
        this.#time,
        el("label", { class: "speed" }, el("span", { class: "word" }, "Speed "), this.#speed),
      ),
      el(
        "div",
        { class: "transport-row" },
        el(
          "div",
          { class: "trials" },
          el("span", { class: "word" }, "Trial"),
          icon("previous", "Trial before ([)", by(-1)),
          this.#trial,
          icon("next", "Next trial (])", by(1)),
          this.#number,
          this.#count,
        ),
        el(
          "fieldset",
          { class: "spans" },
          el("legend", { class: "unseen" }, "What the plots show"),
          el("label", {}, this.#spans.trial, el("span", {}, "this trial")),
          el("label", {}, this.#spans.run, el("span", {}, "whole run")),
        ),
      ),
    );
  }

  show(scene: Scene, playing: boolean, speed: number): void {
    const { run, trial, span } = scene;
    const { trials, duration, steps } = run.picture;
    const stops = Math.max(1, (run.trial(trial)?.stops.length ?? steps + 1) - 1);
    const end = endOf({ ...scene, pinned: null });
    set(this.#scrub, "max", String(end));
    set(this.#scrub, "step", String(duration / stops));
    set(this.#scrub, "value", String(cursorOf(scene)));
    set(this.#trial, "max", String(trials - 1));
    set(this.#trial, "value", String(trial));
    set(this.#number, "max", String(trials - 1));
    if (document.activeElement !== this.#number) set(this.#number, "value", String(trial));
    write(this.#count, `of ${trials}, from 0`);
    const at = `${cursorOf(scene).toFixed(duration < 0.1 ? 5 : 3)} s`;
    write(this.#time, `${at} of ${Number(end.toFixed(6))} s`);
    this.#scrub.setAttribute("aria-valuetext", `${at}, trial ${trial}`);
    this.#trial.setAttribute("aria-valuetext", `trial ${trial} of ${trials}`);
    this.#spans[span].checked = true;
    const nearest = SPEEDS.reduce((a, b) => (Math.abs(b[0] - speed) < Math.abs(a[0] - speed) ? b : a));
    set(this.#speed, "value", String(nearest[0]));
    if (this.#play.dataset["playing"] !== String(playing)) {
      this.#play.dataset["playing"] = String(playing);
      this.#play.setAttribute("aria-label", playing ? "Pause (space)" : "Play (space)");
      this.#play.title = playing ? "Pause (space)" : "Play (space)";
    }
  }
}

function set(field: HTMLInputElement | HTMLSelectElement, name: "max" | "step" | "value", value: string): void {
  if (name === "value" ? field.value !== value : field.getAttribute(name) !== value) {
    if (name === "value") field.value = value;
    else field.setAttribute(name, value);
  }
}
