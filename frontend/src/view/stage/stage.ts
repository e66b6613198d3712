// The structure in motion. Draws only when something has changed and the stage is in view.

import { DirectionalLight, HemisphereLight, Scene as World, WebGLRenderer } from "three";
import { describe, el } from "../../dom";
import { Measure } from "../format";
import type { Look } from "../look";
import type { Run } from "../../run";
import type { Scene } from "../scene";
import type { Trial } from "../trial";
import { Viewer } from "./camera";
import { fitting } from "./exaggeration";
import { Hud, timesText } from "./hud";
import { Model, modelKey } from "./model";
import { Paints } from "./paints";
import { StageTools } from "./tools";

export class Stage {
  readonly #look: Look;
  readonly #hud = new Hud();
  readonly #tools: StageTools;
  readonly #place = el("div", { class: "stage-view" });
  readonly #paints = new Paints();
  readonly #world = new World();
  readonly #renderer: WebGLRenderer | null;
  readonly #viewer: Viewer | null = null;
  #model: Model | null = null;
  #prepared: Run | null = null;
  #made = ""; // the key of the model
  #scene: Scene | null = null;
  #factor = 1;
  #chosen = 0; // exaggeration, 0 for the one that fits
  #asked = 0; // animation frame
  #seen = true;
  #numbers = true; // whether they are to be renewed

  constructor(root: HTMLElement, look: Look, exaggerate: (factor: number) => void) {
    this.#look = look;
    this.#tools = new StageTools({ exaggerate, reset: () => this.#reset() });
    root.append(this.#hud.root, this.#place, this.#tools.root);
    this.#renderer = renderer();
    if (this.#renderer) {
      const canvas = this.#renderer.domElement;
      canvas.setAttribute("role", "img");
      this.#viewer = new Viewer(canvas, () => this.#ask());
      const sun = new DirectionalLight(0xffffff, 1.7);
      sun.position.set(3, 8, 6);
      this.#world.add(new HemisphereLight(0xffffff, 0xc8ccd2, 1.9), sun);
      this.#place.append(canvas);
      new ResizeObserver(() => this.#resize()).observe(this.#place);
      new IntersectionObserver((entries) => {
        this.#seen = entries.at(-1)?.isIntersecting ?? true;
        if (this.#seen) this.#ask();
      }).observe(this.#place);
    } else {
      this.#place.append(
        el(
          "p",
          { class: "stage-without" },
          "This browser offers no WebGL, so the moving structure cannot be drawn; everything else works.",
        ),
      );
    }
  }

  /** What to draw, with deflections `exaggeration` times as large (0: as fits), and whether to renew the numbers. */
  show(scene: Scene, exaggeration: number, numbers: boolean): void {
    this.#scene = scene;
    this.#numbers ||= numbers;
    this.#chosen = exaggeration;
    this.#ask();
  }

  /** What is said of the run where it is named. */
  name(text: string): void {
    this.#hud.name(text);
  }

  repaint(): void {
    this.#paints.take(this.#look, this.#model?.shape.turns ?? false);
    this.#ask();
  }

  #reset(): void {
    this.#viewer?.reset();
    this.#ask();
  }

  #ask(): void {
    if (!this.#asked) this.#asked = requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#asked = 0;
    const scene = this.#scene;
    if (!scene || !this.#seen) return;
    const detail = scene.run.trial(scene.trial);
    if (detail) this.#factor = this.#chosen || factorOf(scene); // while a trial is waited for, what is seen stays
    this.#tools.show(this.#factor, this.#chosen === 0);
    if (this.#renderer && this.#viewer) this.#render(scene, detail, this.#renderer, this.#viewer);
    if (!this.#numbers) return;
    this.#numbers = false;
    if (detail) this.#hud.show(scene, this.#model?.beyond ? "walls out of view" : "");
    else this.#hud.show(scene, `waiting for trial ${scene.trial} …`);
  }

  #render(scene: Scene, detail: Trial | null, renderer: WebGLRenderer, { camera }: Viewer): void {
    this.#prepare(scene);
    if (detail) this.#model?.take(scene.run, detail, scene.time, this.#factor);
    const pinned = scene.pinned?.run ?? null;
    this.#model?.haunt(
      pinned,
      pinned?.trial(scene.trial) ?? null,
      Math.min(scene.time, pinned?.picture.duration ?? 0),
      this.#factor,
    );
    renderer.render(this.#world, camera);
    this.#describe(scene, renderer.domElement);
  }

  #prepare({ run }: Scene): void {
    if (run === this.#prepared) return;
    this.#prepared = run;
    const key = modelKey(run);
    if (key === this.#made) return;
    this.#made = key;
    if (this.#model) {
      this.#world.remove(this.#model.group);
      this.#model.dispose();
    }
    this.#model = new Model(run, this.#paints);
    this.#paints.take(this.#look, this.#model.shape.turns);
    this.#world.add(this.#model.group);
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#place;
    if (!this.#renderer || width === 0 || height === 0) return;
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 1.5));
    this.#renderer.setSize(width, height, false);
    this.#viewer?.fit(width / height);
    this.#ask();
  }

  #describe({ run, trial }: Scene, canvas: HTMLCanvasElement): void {
    const field = run.picture.fields.find(({ unit }) => unit === "m");
    const largest = field ? run.largestOfField(field.name, trial) : 0;
    const moves = field ? `, which deflects by at most ${new Measure(largest, "m").text(largest)}` : "";
    describe(canvas, `The structure in motion in trial ${trial}${moves}; drawn with ${timesText(this.#factor)}.`);
  }
}

/** The factor that fits the trial being looked at. */
function factorOf({ run, trial }: Scene): number {
  const field = run.picture.fields.find(({ unit }) => unit === "m");
  const motions = run.ports.map((port, index) => (port.motion_unit === "m" ? run.largest("y", index, trial) : 0));
  return fitting(Math.max(field ? run.largestOfField(field.name, trial) : 0, ...motions), run.picture.span);
}

function renderer(): WebGLRenderer | null {
  try {
    const made = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "low-power" });
    made.setClearAlpha(0);
    return made;
  } catch {
    return null;
  }
}
