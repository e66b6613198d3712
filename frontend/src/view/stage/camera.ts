// The viewer: a little above and to the side; dragging walks round, within reason.

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { LENGTH } from "./size";

const TARGET = new Vector3(0.51 * LENGTH, 0, 0);
const FROM = new Vector3(0.2, 0.24, 1).normalize();
const [WIDTH, HEIGHT] = [1.34 * LENGTH, 0.74 * LENGTH]; // what must be in view

export class Viewer {
  readonly camera = new PerspectiveCamera(24, 2, 1, 200);
  readonly #orbit: OrbitControls;

  constructor(canvas: HTMLCanvasElement, changed: () => void) {
    this.#orbit = new OrbitControls(this.camera, canvas);
    this.#orbit.enablePan = false;
    this.#orbit.enableZoom = false; // the wheel scrolls the page
    this.#orbit.minPolarAngle = 0.25 * Math.PI;
    this.#orbit.maxPolarAngle = 0.56 * Math.PI;
    this.#orbit.minAzimuthAngle = -0.35 * Math.PI;
    this.#orbit.maxAzimuthAngle = 0.35 * Math.PI;
    this.#orbit.target.copy(TARGET);
    this.#orbit.addEventListener("change", changed);
    canvas.style.touchAction = "pan-y";
  }

  /** Steps back until everything is in view. */
  fit(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    const direction = this.camera.position.clone().sub(TARGET);
    if (direction.lengthSq() < 1e-6 || this.camera.position.lengthSq() < 1e-6) direction.copy(FROM);
    this.#stand(direction.normalize());
  }

  reset(): void {
    this.#stand(FROM);
  }

  #stand(direction: Vector3): void {
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const distance = Math.max(HEIGHT, WIDTH / this.camera.aspect) / (2 * half);
    this.camera.position.copy(TARGET).addScaledVector(direction, distance);
    this.#orbit.update();
  }
}
