// The bar at the top: preset, undo, pin, files, theme.

import { el } from "../dom";
import type { Schema } from "../protocol";
import type { Download } from "../server";
import { THEMES, type Theme, type ThemeSwitch } from "../theme";
import { Menu } from "./menu";

export interface BarActions {
  preset(name: string): void;
  undo(): void;
  redo(): void;
  pin(): void;
  unpin(): void;
  swap(): void;
  beside(): void;
  share(): void;
  download(what: Download): void;
  open(file: File): void;
}

export interface BarState {
  preset: string;
  dirty: boolean;
  canUndo: boolean;
  canRedo: boolean;
  running: boolean;
  pinned: string | null;
}

const DOWNLOADS: readonly { what: Download; label: string }[] = [
  { what: "toml", label: "Scenario (TOML)" },
  { what: "netcdf", label: "Result (NetCDF)" },
  { what: "figures", label: "Figures" },
  { what: "report", label: "Report" },
];

export class Bar {
  private readonly presets: HTMLSelectElement;
  private readonly other = el("option", { hidden: true });
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly pin: HTMLButtonElement;
  private readonly swap: HTMLButtonElement;
  private readonly unpin: HTMLButtonElement;
  private readonly beside: HTMLButtonElement;

  constructor(place: HTMLElement, schema: Schema, actions: BarActions, theme: ThemeSwitch) {
    const button = (label: string, act: () => void, title?: string) =>
      el("button", { type: "button", onclick: act, title }, label);
    const options = schema.scenarios.map(({ name, title }) => el("option", { value: name, title }, name));
    this.presets = el("select", { id: "preset", "aria-label": "Scenario" }, this.other, ...options);
    this.presets.addEventListener("change", () => actions.preset(this.presets.value));
    this.undo = button("↶", actions.undo, "Undo (Ctrl-Z)");
    this.undo.setAttribute("aria-label", "Undo");
    this.redo = button("↷", actions.redo, "Redo (Ctrl-Shift-Z)");
    this.redo.setAttribute("aria-label", "Redo");
    this.pin = button("Pin", actions.pin, "Keep this run, and draw it beside what comes");
    this.swap = button("Swap", actions.swap, "Work on the pinned run, and pin this one");
    this.unpin = button("Unpin", actions.unpin);
    this.beside = button("Beside no control", actions.beside, "Pin the same experiment without control");

    const file = el("input", {
      type: "file",
      accept: ".toml,.nc,.zip",
      hidden: true,
      "aria-label": "Open a scenario or a result",
    });
    file.addEventListener("change", () => {
      const [chosen] = file.files ?? [];
      if (chosen) actions.open(chosen);
      file.value = "";
    });
    const item = (label: string, act: () => void) => el("button", { type: "button", "data-closes": "", onclick: act }, label);
    const downloads = new Menu(
      "Download",
      ...DOWNLOADS.map(({ what, label }) => item(label, () => actions.download(what))),
      item("Link", actions.share),
    );

    const tools = el(
      "div",
      { class: "tools-more", id: "tools" },
      el("div", { class: "set" }, this.pin, this.swap, this.unpin, this.beside),
      el(
        "div",
        { class: "set" },
        button("Share", actions.share, "Copy a link to what you see"),
        downloads.element,
        button("Open…", () => file.click()),
        file,
      ),
      themeSelect(theme),
    );
    const more = el("button", { type: "button", class: "more", "aria-expanded": "false", "aria-controls": "tools" }, "More");
    const unfold = (open: boolean) => {
      more.setAttribute("aria-expanded", String(open));
      tools.classList.toggle("open", open);
    };
    more.addEventListener("click", () => unfold(more.getAttribute("aria-expanded") !== "true"));
    document.addEventListener("keydown", (event) => event.key === "Escape" && unfold(false));
    place.append(this.presets, el("div", { class: "set" }, this.undo, this.redo), more, tools);
  }

  update({ preset, dirty, canUndo, canRedo, running, pinned }: BarState): void {
    const shipped = [...this.presets.options].find((option) => option.value === preset && option !== this.other);
    this.other.hidden = shipped !== undefined && !dirty;
    // A changed scenario has an entry of its own, so that choosing the preset's brings it back.
    this.other.value = shipped && !dirty ? "" : `${preset}*`;
    this.other.textContent = dirty ? `${preset}, changed` : preset;
    this.presets.value = shipped && !dirty ? preset : this.other.value;
    this.undo.disabled = !canUndo;
    this.redo.disabled = !canRedo;
    this.pin.disabled = !running;
    this.beside.disabled = !running;
    this.swap.hidden = this.unpin.hidden = pinned === null;
    this.unpin.title = pinned === null ? "" : `Let go of: ${pinned}`;
  }
}

function themeSelect(theme: ThemeSwitch): HTMLElement {
  const options = THEMES.map((each) => el("option", { value: each }, each === "system" ? "auto" : each));
  const select = el("select", { "aria-label": "Colours" }, ...options);
  select.value = theme.theme;
  select.addEventListener("change", () => (theme.theme = select.value as Theme));
  return select;
}
