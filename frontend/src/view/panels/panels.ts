// All panels: made anew only for another set of ports or fields, and drawn when they are to be seen.

import type { Run } from "../../run";
import type { Scene } from "../scene";
import { Effort } from "./effort";
import { Energy } from "./energy";
import { ActuatorLoop } from "./loop";
import { Motion } from "./motion";
import type { Hands, Panel } from "./panel";
import { Peaks } from "./peaks";
import { Surface } from "./surface";

interface Place {
  panel: Panel;
  seen: boolean;
  stale: boolean;
}

export class Panels {
  readonly #root: HTMLElement;
  readonly #hands: Hands;
  readonly #watch: IntersectionObserver;
  #places: Place[] = [];
  #made = "";
  #scene: Scene | null = null;

  constructor(root: HTMLElement, hands: Hands) {
    this.#root = root;
    this.#hands = hands;
    this.#root.classList.add("panels");
    this.#watch = new IntersectionObserver((entries) => this.#noticed(entries), { rootMargin: "80px" });
  }

  draw(scene: Scene): void {
    this.#scene = scene;
    this.#prepare(scene.run);
    for (const place of this.#places) {
      place.stale = true;
      this.#renew(place);
    }
  }

  cursor(scene: Scene): void {
    this.#scene = scene;
    for (const { panel, seen, stale } of this.#places) if (seen && !stale) panel.cursor(scene);
  }

  repaint(): void {
    for (const { panel } of this.#places) panel.repaint();
  }

  #renew(place: Place): void {
    if (!place.seen || !place.stale || !this.#scene) return;
    place.stale = false;
    place.panel.draw(this.#scene);
    place.panel.cursor(this.#scene);
  }

  #prepare({ picture: { ports, fields, gains } }: Run): void {
    const acts = (index: number) => gains[index] !== 0; // else nothing is ever delivered
    const wanted = JSON.stringify([ports, fields, ports.map((_, index) => acts(index))]);
    if (wanted === this.#made) return;
    this.#made = wanted;
    for (const { panel } of this.#places) panel.destroy();
    this.#watch.disconnect();
    const indices = ports.map((_, index) => index);
    const acting = indices.filter(acts);
    const panels: Panel[] = [
      new Peaks(this.#hands),
      ...indices.map((index) => new Motion(this.#hands, index)),
      ...acting.map((index) => new Effort(this.#hands, index)),
      ...(fields.length > 0 ? [new Surface(this.#hands, fields)] : []),
      ...acting.map((index) => new ActuatorLoop(this.#hands, ports, index)),
      new Energy(this.#hands),
    ];
    this.#places = panels.map((panel) => ({ panel, seen: true, stale: true }));
    this.#root.replaceChildren(...panels.map(({ card }) => card.root));
    for (const panel of panels) this.#watch.observe(panel.card.root);
  }

  #noticed(entries: IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      const place = this.#places.find(({ panel }) => panel.card.root === target);
      if (!place) continue;
      place.seen = isIntersecting;
      this.#renew(place);
      if (place.seen && this.#scene) place.panel.cursor(this.#scene);
    }
  }
}
