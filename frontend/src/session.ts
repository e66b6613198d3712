// The runs on the page: which one is worked on, which one is pinned beside it, and what is still missing of either.

import { Connection, type Lane, type Question } from "./connection";
import type { Detail, Fault, Framed, Opened, Picture, Said, Table } from "./protocol";
import { Run } from "./run";
import type { View } from "./view/view";

/** What a run is made from: a table that began as a preset, or a stored result that the server holds. */
export interface Source {
  preset: Opened;
  table: Table;
  label: string;
  token?: string | undefined;
}

/** A run on the page. Its details come one by one, and are broken off when something newer is asked for. */
export interface Shown {
  source: Source;
  run: Run;
  id: number;
  /** Whether its details are on their way, have been broken off, or are all here. */
  details: "coming" | "left" | "complete";
}

interface Asking {
  lane: Lane;
  source: Source;
  /** The run whose details are asked for again; null: a new run. */
  missing: Shown | null;
}

export interface SessionEvents {
  drawn(picture: Picture): void;
  /** What holds in the run; null: being worked out. */
  reviewed(review: Extract<Said, { say: "review" }> | null): void;
  pinned(label: string | null): void;
  refused(faults: Fault[]): void;
  /** The scenario has no run: the one on the page is another's. */
  without(): void;
  failed(text: string): void;
  note(text: string): void;
  line(open: boolean): void;
}

const QUIET = 400; // ms without a newer request, until missing details are asked for again

export class Session {
  now: Shown | null = null;
  pinned: Shown | null = null;
  private readonly connection: Connection;
  private readonly asked = new Map<number, Asking>();
  private timer = 0;
  /** The newest question for a run to work on: an older one's answer may be drawn, but is not the scenario's. */
  private newest = 0;

  constructor(
    private readonly view: View,
    private readonly events: SessionEvents,
  ) {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    this.connection = new Connection(`${scheme}://${location.host}/ws`, {
      picture: (frame) => void this.picture(frame),
      detail: (frame) => this.detail(frame),
      said: (said) => this.said(said),
      open: (open) => this.line(open),
    });
  }

  /** Has a scenario run; it becomes what is worked on. */
  run(source: Source): number {
    this.view.stand("coming");
    this.newest = this.ask({ lane: "now", source, missing: null });
    return this.newest;
  }

  /** Has a scenario run and pins it. */
  runBeside(source: Source): void {
    this.ask({ lane: "beside", source, missing: null });
  }

  /** Pins a run beside the one that is worked on; null: none. */
  pin(shown: Shown | null): void {
    this.pinned = shown;
    this.view.pin(shown?.run ?? null, shown?.source.label ?? "");
    this.events.pinned(shown?.source.label ?? null);
    this.soon();
  }

  /** Another trial is being looked at. */
  look(trial: number): void {
    const { now, pinned } = this;
    if (now && trial < now.run.picture.trials && !now.run.has(trial)) this.refill("now", now);
    if (pinned && pinned !== now && trial < pinned.run.picture.trials && !pinned.run.has(trial)) this.refill("beside", pinned);
  }

  private ask(asking: Asking): number {
    const { table, token } = asking.source;
    const { trial } = this.view.state;
    const question: Question = token === undefined ? { do: "run", table, trial } : { do: "open", token, trial };
    const id = this.connection.ask(asking.lane, question);
    this.asked.set(id, asking);
    this.soon();
    return id;
  }

  private refill(lane: Lane, shown: Shown): void {
    shown.id = this.ask({ lane, source: shown.source, missing: shown });
    shown.details = "coming";
  }

  private async picture(frame: Framed<Picture>): Promise<void> {
    const { id } = frame.header;
    const asking = this.asked.get(id);
    if (!asking) return;
    this.forget(id, asking.lane);
    if (asking.missing) {
      this.add(asking.missing.run, detailIn(frame));
      return;
    }
    const shown: Shown = { source: asking.source, run: new Run(frame), id, details: "coming" };
    if (asking.lane === "beside") {
      this.pin(shown);
      return;
    }
    this.now = shown;
    this.review(null);
    await this.view.show(shown.run, shown.source.label, id === this.newest ? "own" : "coming");
    if (this.now === shown && id === this.newest) this.events.drawn(frame.header);
    tell("dampen:drawn", id);
  }

  private detail(frame: Framed<Detail>): void {
    for (const { run } of this.showing(frame.header.id)) this.add(run, frame);
  }

  private add(run: Run, frame: Framed<Detail>): void {
    run.add(frame);
    this.view.more(run);
  }

  private said(said: Said): void {
    switch (said.say) {
      case "note":
        this.events.note(said.text);
        break;
      case "refused":
        if (this.concerns(said.id)) this.events.refused(said.faults);
        break;
      case "failed":
        if (this.concerns(said.id)) this.events.failed(said.text);
        break;
      case "review":
        if (this.now?.id !== said.id) break;
        this.review(said);
        tell("dampen:review", said.id);
        break;
      case "complete":
      case "left":
        for (const shown of this.showing(said.id)) shown.details = said.say;
        this.soon();
        break;
    }
  }

  private review(review: Extract<Said, { say: "review" }> | null): void {
    this.view.review(review);
    this.events.reviewed(review);
  }

  /** A question has been answered without a run: whether that concerns anyone still, nothing newer having been asked. */
  private concerns(id: number): boolean {
    const asking = this.asked.get(id);
    if (asking) this.forget(id, asking.lane);
    // What could not be had a second time is not asked for a third time.
    if (asking?.missing) asking.missing.details = "complete";
    if (asking && id === this.newest) {
      this.view.stand("other");
      this.events.without();
    }
    return asking?.lane === "beside" || id === 0 || id >= this.newest;
  }

  /** Older questions of the lane will not be answered any more: something newer has overtaken them. */
  private forget(id: number, lane: Lane): void {
    for (const [older, asking] of this.asked) if (older <= id && asking.lane === lane) this.asked.delete(older);
  }

  private line(open: boolean): void {
    for (const shown of [this.now, this.pinned]) if (!open && shown?.details === "coming") shown.details = "left";
    if (this.asked.has(this.newest)) this.view.stand(open ? "coming" : "other");
    if (open) this.soon();
    this.events.line(open);
  }

  private showing(id: number): Shown[] {
    const { now, pinned } = this;
    return [now, pinned === now ? null : pinned].filter((shown) => shown?.id === id) as Shown[];
  }

  /** After a while of quiet asks for details that were broken off, first of the run that is worked on. */
  private soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      const { now, pinned } = this;
      if (!this.connection.idle) return;
      if (now?.details === "left") this.refill("now", now);
      else if (now?.details !== "coming" && pinned?.details === "left") this.refill("beside", pinned);
    }, QUIET);
  }
}

/** A picture holds the detail of one trial; for a run that is there already it is nothing else. */
function detailIn(frame: Framed<Picture>): Framed<Detail> {
  const { id, trial, arrays } = frame.header;
  return {
    header: { say: "trial", id, trial, arrays },
    array: (name) => frame.array(name),
    shape: (name) => frame.shape(name),
    has: (name) => frame.has(name),
  };
}

/** For tests and benchmarks. */
export const tell = (event: string, id: number): boolean => window.dispatchEvent(new CustomEvent(event, { detail: { id } }));
