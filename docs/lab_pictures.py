"""The pictures of the lab in README and docs: `python docs/lab_pictures.py`, with Chromium on the path.

The paper's experiment beside the same without control, in trial 1, as a desktop and a phone show it.
"""

from __future__ import annotations

import io
import shutil
import signal
import subprocess
import sys
from pathlib import Path

from PIL import Image
from playwright.sync_api import Browser, sync_playwright

IMAGES = Path(__file__).parent / "images"
SIZES = {"": ({"width": 1440, "height": 900}, 1), "-phone": ({"width": 390, "height": 844}, 2)}
CHROMIUM = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking", "--no-first-run"]


def picture(browser: Browser, address: str, size: str, scheme: str) -> None:
    """One page, photographed."""
    viewport, scale = SIZES[size]
    context = browser.new_context(viewport=viewport, color_scheme=scheme, device_scale_factor=scale, reduced_motion="reduce")
    page = context.new_page()
    page.goto(address)
    page.get_by_text("claims hold").first.wait_for()
    if size:
        page.get_by_role("button", name="More").click()
    page.get_by_role("button", name="Beside no control").click()
    page.locator("#panels .legend").get_by_text("no control").first.wait_for()
    if size:
        page.keyboard.press("Escape")
    page.get_by_label("Number of the trial").fill("1")
    page.get_by_label("Number of the trial").press("Enter")
    page.evaluate(
        "() => { const s = document.querySelector('.stage-tools input[type=range]');"
        "s.value = 303; s.dispatchEvent(new Event('input')); }"  # as large as they are
    )
    page.get_by_role("slider", name="Time", exact=True).fill("0.4")
    page.locator("body").click(position={"x": 5, "y": 5})
    page.wait_for_timeout(1500)
    shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    shot.save(IMAGES / f"lab{size}{'-dark' if scheme == 'dark' else ''}.png", optimize=True)
    context.close()


def main() -> None:
    """All of them."""
    command = [sys.executable, "-m", "dampen.cli", "lab", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as lab, sync_playwright() as p:
        browser = p.chromium.launch(executable_path=shutil.which("chromium"), args=CHROMIUM)
        address = lab.stdout.readline().split()[1]
        for size in SIZES:
            for scheme in ("light", "dark"):
                picture(browser, address, size, scheme)
        browser.close()
        lab.send_signal(signal.SIGINT)


if __name__ == "__main__":
    main()
