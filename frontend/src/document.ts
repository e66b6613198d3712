// The scenario that is being worked on: immutable snapshots, with undo and redo.

import { equal, type Path, valueAt, withValue, without } from "./path";
import type { Opened, Table, Value } from "./protocol";

/** What else goes back and forth with a step. */
export interface Along {
  undo(): void;
  redo(): void;
}

/** One state of the work: a table, the preset that it came from, and what went along with the step to it. */
interface Snapshot {
  preset: Opened;
  table: Table;
  along?: Along | undefined;
}

const LONGEST_HISTORY = 500;

export class ScenarioDocument {
  private now: Snapshot;
  private past: Snapshot[] = [];
  private future: Snapshot[] = [];
  /** The gesture that made the newest snapshot, while it lasts: all of one drag is one step to undo. */
  private gesture: string | null = null;

  constructor(
    opened: Opened,
    private readonly changed: () => void,
  ) {
    this.now = { preset: opened, table: opened.table };
  }

  get table(): Table {
    return this.now.table;
  }

  get preset(): Opened {
    return this.now.preset;
  }

  get dirty(): boolean {
    return !equal(this.now.table, this.now.preset.table);
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  value(path: Path): Value | undefined {
    return valueAt(this.now.table, path);
  }

  /** Whether the value at `path` differs from the preset's. */
  differs(path: Path): boolean {
    return !equal(this.value(path), valueAt(this.now.preset.table, path));
  }

  set(path: Path, value: Value, gesture: string | null = null): void {
    if (equal(this.value(path), value)) return;
    this.step({ preset: this.preset, table: withValue(this.now.table, path, value) as Table }, gesture);
  }

  remove(path: Path): void {
    if (this.value(path) !== undefined) this.step({ preset: this.preset, table: without(this.now.table, path) });
  }

  /** Back to what the preset has at `path`. */
  revert(path: Path): void {
    const before = valueAt(this.now.preset.table, path);
    if (before === undefined) this.remove(path);
    else this.set(path, before);
  }

  /** Another preset, and a table that began as it. */
  open(preset: Opened, table: Table = preset.table, along?: Along): void {
    this.step({ preset, table, along });
  }

  /** Begins anew, with nothing to undo. */
  begin(preset: Opened, table: Table): void {
    this.now = { preset, table };
    this.past = [];
    this.future = [];
    this.gesture = null;
    this.changed();
  }

  /** The gesture is over: what comes next is a step of its own. */
  settle(): void {
    this.gesture = null;
  }

  undo(): void {
    const { along } = this.now;
    if (this.travel(this.past, this.future)) along?.undo();
  }

  redo(): void {
    if (this.travel(this.future, this.past)) this.now.along?.redo();
  }

  private step(next: Snapshot, gesture: string | null = null): void {
    if (gesture === null || gesture !== this.gesture) this.past.push(this.now);
    if (this.past.length > LONGEST_HISTORY) this.past.shift();
    this.gesture = gesture;
    this.future = [];
    this.now = next;
    this.changed();
  }

  /** Whether there was a step to go. */
  private travel(from: Snapshot[], to: Snapshot[]): boolean {
    const found = from.pop();
    if (!found) return false;
    to.push(this.now);
    this.now = found;
    this.gesture = null;
    this.changed();
    return true;
  }
}
