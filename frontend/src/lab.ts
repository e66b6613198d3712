// The page as a whole: what the user does to the scenario, and what comes of it.

import { Address } from "./address";
import { nameOf } from "./changes";
import { Form } from "./controls/form";
import { ControlsPanel } from "./controls/panel";
import { ScenarioDocument } from "./document";
import { place } from "./dom";
import { Bar, type BarActions } from "./header/bar";
import { Status } from "./header/status";
import { equal } from "./path";
import type { Fault, Opened, Picture, Schema } from "./protocol";
import { attachFile, type Download, download, fetchScenario, readFile, Refused } from "./server";
import { Session, type Source, tell } from "./session";
import type { ThemeSwitch } from "./theme";
import { uncontrolled } from "./uncontrolled";
import { View } from "./view/view";

const MAKING: { readonly [what in Download]: string } = {
  toml: "Writing the scenario.",
  netcdf: "Writing the result.",
  figures: "Drawing the figures; this takes a few seconds.",
  report: "Making the report; this takes a few seconds.",
};

export class Lab {
  private readonly status = new Status();
  private readonly scenario: ScenarioDocument;
  private readonly view: View;
  private readonly session: Session;
  private readonly panel: ControlsPanel;
  private readonly bar: Bar;
  private readonly address: Address;
  private pinned: string | null = null;

  constructor(
    private readonly schema: Schema,
    private readonly start: Opened,
    theme: ThemeSwitch,
  ) {
    this.scenario = new ScenarioDocument(start, () => this.changed());
    const places = { stage: place("stage"), transport: place("transport"), panels: place("panels"), verdicts: place("verdicts") };
    this.view = new View(places, {
      trial: (trial) => this.session.look(trial),
      state: () => this.address.renew(),
    });
    this.address = new Address(() => {
      const { preset, table } = this.scenario;
      return { v: 1, preset: preset.name, table, view: this.view.state };
    });
    this.session = new Session(this.view, {
      drawn: (picture) => this.drawn(picture),
      reviewed: (review) => this.status.reviewed(review),
      pinned: (label) => this.nowPinned(label),
      refused: (faults) => this.refused(faults, "Not run"),
      without: () => this.status.withoutRun(),
      failed: (text) => this.failed(text),
      note: (text) => this.status.say(text),
      line: (open) => this.status.line(open),
    });
    this.panel = new ControlsPanel(place("controls"), new Form(schema, this.scenario, attachFile));
    this.bar = new Bar(place("bar"), schema, this.actions, theme);
    this.refreshBar();
  }

  /** Shows what the address holds; without anything there, what the command line asked for. */
  async begin(): Promise<void> {
    await this.follow((linked) => {
      const { preset, table } = linked ?? { preset: this.start, table: this.start.table };
      this.scenario.begin(preset, table);
    });
  }

  /** The address has changed: shows what it holds. */
  async navigate(): Promise<void> {
    await this.follow((linked) => linked && this.scenario.open(linked.preset, linked.table));
  }

  colours(dark: boolean): void {
    this.view.colours(dark);
  }

  undo(): void {
    this.scenario.undo();
  }

  redo(): void {
    this.scenario.redo();
  }

  async open(file: File): Promise<void> {
    this.status.say(`Reading ${file.name}.`);
    await this.attempt("Not read", async () => this.scenario.open(await readFile(file)));
  }

  private readonly actions: BarActions = {
    preset: (name) => void this.attempt("Not opened", async () => this.scenario.open(await fetchScenario(name))),
    undo: () => this.undo(),
    redo: () => this.redo(),
    pin: () => this.session.pin(this.session.now),
    unpin: () => this.session.pin(null),
    swap: () => this.swap(),
    beside: () => this.besideNoControl(),
    share: () => void this.share(),
    download: (what) => void this.save(what),
    open: (file) => void this.open(file),
  };

  /** The scenario has changed: first the question, the form is brought up to date while the server works. */
  private changed(): void {
    tell("dampen:changed", this.session.run(this.source()));
    this.status.expect();
    this.panel.update();
    this.refreshBar();
    this.address.renew();
  }

  private drawn(picture: Picture): void {
    this.panel.learn(picture);
    this.panel.show([]);
    this.status.picture(picture);
    this.refreshBar();
  }

  private nowPinned(label: string | null): void {
    this.pinned = label;
    this.status.say(label === null ? "Nothing is pinned." : `Pinned: ${label}.`);
    this.refreshBar();
  }

  /** The last good run stays on the page. */
  private refused(faults: Fault[], undone: string): void {
    this.panel.show(faults);
    this.status.faults(faults, undone);
  }

  private failed(text: string): void {
    this.status.say("Not run.", true);
    this.status.tell(text);
  }

  private source(): Source {
    const { preset, table } = this.scenario;
    // A stored result is shown as it was, as long as nothing is changed.
    const token = equal(table, preset.table) ? preset.token : undefined;
    return { preset, table, token, label: nameOf(preset.name, table, preset.table) };
  }

  private besideNoControl(): void {
    const { preset, table } = this.scenario;
    this.session.runBeside({ preset, table: uncontrolled(table), label: "no control" });
  }

  /** Works on the pinned run, and pins the one that was worked on. */
  private swap(): void {
    const { now, pinned } = this.session;
    if (!now || !pinned) return;
    this.session.pin(now);
    // What was pinned is run again when the swap is undone: to keep whole runs for every step would take too much memory.
    const along = {
      undo: () => this.session.runBeside(pinned.source),
      redo: () => this.session.runBeside(now.source),
    };
    this.scenario.open(pinned.source.preset, pinned.source.table, along);
  }

  private async save(what: Download): Promise<void> {
    this.status.say(MAKING[what]);
    await this.attempt("Not written", async () => {
      const { table, token } = this.source();
      await download(what, table, token);
      this.status.say("The download is ready.");
    });
  }

  private async share(): Promise<void> {
    await this.address.write();
    try {
      await navigator.clipboard.writeText(location.href);
      this.status.say("The link has been copied.");
    } catch {
      this.status.say("The link is in the address bar.");
    }
  }

  /** Reads the address, restores the view's state, and does with the scenario in it what is to be done. */
  private async follow(act: (linked: Pick<Source, "preset" | "table"> | null) => void): Promise<void> {
    try {
      const linked = await this.address.read();
      const preset = linked && (await this.presetOf(linked));
      if (linked) this.view.state = linked.view;
      act(linked && preset && { preset, table: linked.table });
    } catch {
      act(null);
      this.status.tell("This link is broken; it has not been followed.");
    }
  }

  /** The preset that a link's table is compared with; where this server has no such scenario, the table itself. */
  private async presetOf({ preset, table }: Pick<Opened, "table"> & { preset: string }): Promise<Opened> {
    if (preset === this.start.name) return this.start;
    const shipped = this.schema.scenarios.some(({ name }) => name === preset);
    return shipped ? fetchScenario(preset) : { name: preset, table };
  }

  /** Does what needs the server, and says where that fails. */
  private async attempt(undone: string, act: () => Promise<void>): Promise<void> {
    try {
      await act();
    } catch (error) {
      if (error instanceof Refused) this.refused(error.faults, undone);
      else this.status.say("The server does not answer.", true);
    }
  }

  private refreshBar(): void {
    const { preset, dirty, canUndo, canRedo } = this.scenario;
    document.title = `${preset.name}${dirty ? ", changed" : ""} · dampen lab`;
    this.bar.update({ preset: preset.name, dirty, canUndo, canRedo, running: this.session.now !== null, pinned: this.pinned });
  }
}
