// Stage, transport, panels and verdicts over one run, with one time for all of them.

import type { Said } from "../protocol";
import type { Run } from "../run";
import { instantOf, later } from "./clock";
import { Look } from "./look";
import { Panels } from "./panels/panels";
import { lastUpTo } from "./nearest";
import type { Pinned, Scene } from "./scene";
import { onKeys } from "./shortcuts";
import { Stage } from "./stage/stage";
import { Mark, type Standing } from "./standing";
import { initial, type ViewState } from "./state";
import { Transport } from "./transport";
import { Verdicts } from "./verdicts";
import "./view.css";

export interface ViewEvents {
  trial(trial: number): void; // another trial is being looked at
  state(): void; // the view's state has changed
}

export interface Places {
  stage: HTMLElement;
  transport: HTMLElement;
  panels: HTMLElement;
  verdicts: HTMLElement;
}

const PAUSE = 60; // between two renewals of the numbers while playing [ms]
const HAIR = 1e-6; // of a trial
const FRAME = 0.1; // a longer pause between two frames does not let time jump [s]
const BUSY = 3; // of so many frames one is drawn while an answer is waited for: its own drawing needs the processor

export class View {
  readonly #events: ViewEvents;
  readonly #look = new Look();
  readonly #stage: Stage;
  readonly #transport: Transport;
  readonly #panels: Panels;
  readonly #verdicts: Verdicts;
  readonly #mark: Mark;
  readonly #state = initial();
  readonly #complete = new WeakSet<Run>(); // runs that are drawn with the detail of the trial being looked at
  #run: Run | null = null;
  #label = ""; // of the run
  #busy = false; // whether an answer is waited for
  #frames = 0; // since one was drawn
  #pinned: Pinned | null = null;
  #tick = 0; // animation frame while playing
  #last = 0; // its time [ms]
  #said = -Infinity; // when numbers were last renewed while playing [ms]

  constructor(places: Places, events: ViewEvents) {
    this.#events = events;
    const seek = (time: number) => this.#seek(time);
    const jump = (trial: number) => this.#jump(trial);
    const step = (by: 1 | -1) => this.#step(by);
    const play = (playing: boolean) => this.#change({ playing });
    this.#stage = new Stage(places.stage, this.#look, (exaggeration) => this.#change({ exaggeration }));
    this.#transport = new Transport(places.transport, {
      play,
      step,
      seek,
      jump,
      speed: (speed) => this.#change({ speed }),
      span: (span) => this.#change({ span }),
    });
    this.#panels = new Panels(places.panels, { look: this.#look, seek, jump });
    this.#verdicts = new Verdicts(places.verdicts);
    this.#mark = new Mark([places.stage, places.panels, places.verdicts], (text) => this.#stage.name(text));
    onKeys({
      " ": () => play(!this.#state.playing),
      ",": () => step(-1),
      ".": () => step(1),
      "[": () => jump(this.#state.trial - 1),
      "]": () => jump(this.#state.trial + 1),
    });
  }

  get state(): ViewState {
    return { ...this.#state };
  }

  set state(state: Partial<ViewState>) {
    this.#take(state);
  }

  /** How the run that is drawn stands to the scenario. While the scenario's own is to come, time is drawn less often. */
  stand(standing: Standing): void {
    this.#stand(standing, false);
  }

  /** The current run; resolves in the animation frame after everything has been redrawn. */
  async show(run: Run, label: string, standing: Standing): Promise<void> {
    this.#run = run;
    this.#label = label;
    this.#stand(standing, true);
    this.#take({}, true);
    if (!document.hidden) await new Promise((resolve) => requestAnimationFrame(resolve));
  }

  /** A detail has come, of the current run or of the pinned one. */
  more(run: Run): void {
    const scene = this.#scene();
    if (!scene || (run !== this.#run && run !== this.#pinned?.run)) return;
    if (run.has(scene.trial) && !this.#complete.has(run)) this.#redraw(scene);
  }

  pin(run: Run | null, label: string): void {
    this.#pinned = run && { run, label };
    const scene = this.#scene();
    if (scene) this.#redraw(scene);
  }

  review(said: Extract<Said, { say: "review" }> | null): void {
    this.#verdicts.show(said);
  }

  colours(dark: boolean): void {
    this.#look.read(dark);
    this.#stage.repaint();
    this.#panels.repaint();
  }

  #stand(standing: Standing, fresh: boolean): void {
    const busy = standing === "coming";
    this.#busy = busy;
    this.#mark.show(standing, this.#label, fresh);
  }

  #scene(): Scene | null {
    const { trial, time, span } = this.#state;
    return this.#run && { run: this.#run, pinned: this.#pinned, trial, time, span };
  }

  #seek(at: number): void {
    if (!this.#run) return;
    const { trials, duration } = this.#run.picture;
    if (this.#state.span === "run") this.#change(instantOf(at, trials, duration));
    else this.#change({ time: Math.min(Math.max(at, 0), duration) });
  }

  #jump(trial: number): void {
    if (!this.#run || !Number.isFinite(trial)) return;
    this.#change({ trial: Math.min(Math.max(Math.round(trial), 0), this.#run.picture.trials - 1) });
  }

  #step(by: 1 | -1): void {
    const stops = this.#run?.trial(this.#state.trial)?.stops;
    if (!this.#run || !stops) return;
    const { trials, duration } = this.#run.picture;
    const hair = HAIR * duration; // times are rounded differently
    const next = by > 0 ? lastUpTo(stops, this.#state.time + hair) + 1 : lastUpTo(stops, this.#state.time - hair);
    const time = stops[next];
    if (time !== undefined) this.#change({ playing: false, time });
    else
      this.#change({
        playing: false,
        ...later(
          { trial: this.#state.trial, time: by > 0 ? duration : 0 },
          by > 0 ? 0 : trials * duration - 1e-9,
          trials,
          duration,
        ),
      });
  }

  /** A change that the user has made. */
  #change(state: Partial<ViewState>): void {
    this.#take(state);
    this.#events.state();
  }

  /** Takes a state and draws what it changes. */
  #take(state: Partial<ViewState>, fresh = false): void {
    const before = { ...this.#state };
    Object.assign(this.#state, state);
    const run = this.#run;
    if (!run) return;
    this.#state.trial = Math.min(this.#state.trial, Math.max(run.picture.trials - 1, 0));
    this.#state.time = Math.min(this.#state.time, run.picture.duration);
    run.looked = this.#state.trial;
    const moved = before.trial !== this.#state.trial;
    const scene = this.#scene()!;
    if (fresh || moved || before.playing !== this.#state.playing) this.#said = -Infinity;
    if (fresh || moved || before.span !== this.#state.span) this.#redraw(scene);
    else this.#follow(scene);
    if (moved || (fresh && !run.has(this.#state.trial))) this.#events.trial(this.#state.trial);
    this.#play();
  }

  #redraw(scene: Scene): void {
    for (const run of [scene.run, scene.pinned?.run]) {
      if (run?.has(scene.trial)) this.#complete.add(run);
      else if (run) this.#complete.delete(run);
    }
    this.#panels.draw(scene);
    this.#follow(scene);
  }

  #follow(scene: Scene): void {
    // Numbers that change sixty times a second cannot be read, and cost a layout each.
    const now = performance.now();
    const numbers = !this.#state.playing || now - this.#said > PAUSE;
    if (numbers) this.#said = now;
    this.#stage.show(scene, this.#state.exaggeration, numbers);
    if (numbers) this.#transport.show(scene, this.#state.playing, this.#state.speed);
    this.#panels.cursor(scene);
  }

  #play(): void {
    if (this.#state.playing && !this.#tick) {
      this.#last = performance.now();
      this.#tick = requestAnimationFrame((now) => this.#frame(now));
    }
  }

  #frame(now: number): void {
    this.#tick = 0;
    const run = this.#run;
    if (!run || !this.#state.playing) return;
    if (this.#busy && ++this.#frames < BUSY) {
      this.#tick = requestAnimationFrame((next) => this.#frame(next));
      return;
    }
    this.#frames = 0;
    const seconds = Math.min(Math.max(now - this.#last, 0) / 1000, FRAME) * this.#state.speed;
    this.#last = now;
    const { trials, duration } = run.picture;
    // While a trial's detail is on its way, time stands still.
    if (run.has(this.#state.trial) && trials > 0) this.#take(later(this.#state, seconds, trials, duration));
    this.#tick ||= requestAnimationFrame((next) => this.#frame(next));
  }
}
