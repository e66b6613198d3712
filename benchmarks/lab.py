"""How quickly the lab answers a hand, in a real browser: `python benchmarks/lab.py`.

Headless Chromium with WebGL in software, a lab of its own on loopback, the paper's experiment of 25 trials:

    first picture       from the command to the first drawn page, the browser being open already
    slider to drawing   from a slider's input event to the animation frame after all panels have been drawn again
    stage               frames a second in which the stage was drawn, while it plays
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from statistics import median, quantiles

from playwright.sync_api import Browser, Page, sync_playwright

SLIDER = "controller.alpha_4"
CHROMIUM = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking", "--no-first-run"]
CHROMIUM += ["--disable-component-update", "--disable-sync"]
WATCH = """
window.log = { drawn: [], took: [], frames: [], asked: new Map(), rendered: false };
addEventListener("dampen:changed", (e) => log.asked.set(e.detail.id, performance.now()));
addEventListener("dampen:drawn", (e) => {
  const now = performance.now(), asked = log.asked.get(e.detail.id);
  log.drawn.push(performance.timeOrigin + now);
  if (asked !== undefined) log.took.push(now - asked);
});
for (const name of ["drawElements", "drawArrays"]) {
  const draw = WebGL2RenderingContext.prototype[name];
  WebGL2RenderingContext.prototype[name] = function (...given) { log.rendered = true; return draw.apply(this, given); };
}
const count = () => {
  if (log.rendered) log.frames.push(performance.now());
  log.rendered = false;
  requestAnimationFrame(count);
};
requestAnimationFrame(count);
"""
MOVE = """([path, position]) => {
  const slider = document.querySelector(`[data-slider="${path}"]`);
  slider.value = String(Number(slider.min) + position * (Number(slider.max) - Number(slider.min)));
  slider.dispatchEvent(new Event("input", { bubbles: true }));
}"""
DRAG = """([path, seconds]) => new Promise((done) => {
  const slider = document.querySelector(`[data-slider="${path}"]`);
  const low = Number(slider.min), high = Number(slider.max), begun = performance.now();
  const move = (now) => {
    const phase = (now - begun) / 1000;
    if (phase > seconds) return done();
    slider.value = String(low + (high - low) * (0.5 + 0.3 * Math.sin(2 * phase)));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    requestAnimationFrame(move);
  };
  requestAnimationFrame(move);
})"""


def row(what: str, values: list[float], unit: str = "ms") -> None:
    """Median, 95th percentile and largest of some figures."""
    late = quantiles(values, n=20)[-1]
    print(f"{what:<52} median {median(values):6.0f}   95 % {late:6.0f}   largest {max(values):6.0f} {unit}   ({len(values)})")


def first_picture(browser: Browser) -> float:
    """Seconds from the command to the first picture, in a lab that ends again."""
    page = watched(browser)
    began = time.time()
    with lab() as address:
        page.goto(address)
        page.wait_for_function("log.drawn.length > 0")
        drawn = page.evaluate("log.drawn[0]") / 1000
    page.context.close()
    return drawn - began


class lab:
    """A lab while it is needed."""

    def __enter__(self) -> str:
        command = [sys.executable, "-m", "dampen.cli", "lab", "--no-browser", "--port", "0"]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        return self.process.stdout.readline().split()[1]

    def __exit__(self, *_: object) -> None:
        self.process.send_signal(signal.SIGINT)
        self.process.wait()


def watched(browser: Browser) -> Page:
    """A new page that keeps a log."""
    page = browser.new_context(viewport={"width": 1440, "height": 900}, bypass_csp=True).new_page()
    page.add_init_script(WATCH)
    return page


def slider(page: Page, changes: int) -> list[float]:
    """Milliseconds from input to drawing, one change after the other, with the pauses of a hand."""
    page.evaluate("log.took.length = 0")
    for _ in range(changes):
        before = page.evaluate("log.took.length")
        page.evaluate(MOVE, [SLIDER, random.uniform(0.2, 0.8)])
        page.wait_for_function(f"log.took.length > {before}")
        time.sleep(random.uniform(0.05, 0.5))
    return page.evaluate("log.took")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--changes", type=int, default=100)
    given = parser.parse_args()
    random.seed(1)
    path = shutil.which("chromium") or os.environ.get("CHROMIUM")
    with sync_playwright() as p:
        browser = p.chromium.launch(executable_path=path, args=CHROMIUM)
        print(f"Chromium {browser.version}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
        row("first picture, from the command", [1000 * first_picture(browser) for _ in range(5)])
        with lab() as address:
            page = watched(browser)
            page.goto(address)
            page.wait_for_function("log.drawn.length > 0")
            time.sleep(3)
            page.evaluate("log.frames.length = 0")
            time.sleep(5)
            frames = page.evaluate("log.frames")
            print(f"{'stage, playing':<52} {1000 * (len(frames) - 1) / (frames[-1] - frames[0]):6.1f} frames a second")
            row("slider to drawing, stage playing", slider(page, given.changes))
            page.evaluate("log.took.length = 0")
            page.evaluate(DRAG, [SLIDER, 6])
            row("slider to drawing, dragging, stage playing", page.evaluate("log.took"))
            page.keyboard.press("Space")
            row("slider to drawing, stage at rest", slider(page, given.changes))
        browser.close()


if __name__ == "__main__":
    main()
