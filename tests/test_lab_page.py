"""The lab's page in a real browser: what a hand does there, and that nothing goes wrong or out meanwhile.

Needs Chromium; where there is none the tests are skipped, unless DAMPEN_BROWSER says that there must be one.
"""

from __future__ import annotations

import base64
import json
import os
import re
import shutil
import zlib
from urllib.parse import urlsplit

import numpy as np
import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Browser, Page, expect, sync_playwright

import dampen
from dampen.analysis.metrics import error_peaks
from dampen.scenarios.read import shipped, table_of
from tests.lab import lab_process

CHROMIUM = os.environ.get("DAMPEN_BROWSER") or shutil.which("chromium") or shutil.which("chromium-browser")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="no Chromium on this machine")
SETTINGS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking", "--no-first-run"]
SETTINGS += ["--disable-component-update", "--disable-sync"]
WATCH = """
window.drawn = []; window.reviewed = [];
addEventListener("dampen:drawn", (e) => drawn.push(e.detail.id));
addEventListener("dampen:review", (e) => reviewed.push(e.detail.id));
"""
GAIN, SLIDER = '[data-path="controller.alpha_4"]', '[data-slider="controller.alpha_4"]'
DESKTOP, PHONE = {"width": 1440, "height": 900}, {"width": 390, "height": 844}


@pytest.fixture(scope="module")
def address():
    with lab_process() as (address, _):
        yield address


@pytest.fixture(scope="module")
def browser():
    with sync_playwright() as p:
        browser = p.chromium.launch(executable_path=CHROMIUM, args=SETTINGS)
        yield browser
        browser.close()


class Hand:
    """Someone at the page, who notices every error on the console and every request that leaves this machine."""

    def __init__(self, browser: Browser, address: str, viewport=DESKTOP, scheme="light", path="/"):
        self.context = browser.new_context(viewport=viewport, color_scheme=scheme, reduced_motion="reduce", accept_downloads=True)
        self.context.grant_permissions(["clipboard-read", "clipboard-write"])
        self.address, self.troubles = address, []
        self.page = self.open(path)

    def open(self, path: str) -> Page:
        page = self.context.new_page()
        page.set_default_timeout(120_000)
        page.on("console", lambda message: self.troubles.append(message.text) if message.type in ("error", "warning") else None)
        page.on("pageerror", lambda error: self.troubles.append(str(error)))
        page.on("request", lambda request: self.check(request.url))
        page.on("websocket", lambda socket: self.check(socket.url))
        page.add_init_script(WATCH)
        page.goto(self.address + path)
        self.wait(page, "drawn", 0)
        return page

    def check(self, url: str) -> None:
        if urlsplit(url).scheme not in ("data", "blob") and urlsplit(url).netloc != urlsplit(self.address).netloc:
            self.troubles.append(f"a request went to {url}")

    def wait(self, page: Page, what: str, count: int) -> None:
        """Until more than `count` events have come; by polling, since the page's policy forbids evaluated text."""
        for _ in range(6000):
            if page.evaluate(f"() => {what}.length") > count:
                return
            page.wait_for_timeout(50)
        raise AssertionError(f"nothing was {what} for five minutes; troubles: {self.troubles}")

    def drawn(self) -> int:
        return self.page.evaluate("() => drawn.length")

    def after(self, act) -> None:
        """Do something, and wait for what it makes the page draw."""
        before = self.drawn()
        act()
        self.wait(self.page, "drawn", before)

    def peaks(self, page: Page | None = None) -> np.ndarray:
        """(trials, ports) the page's table of peaks."""
        rows = (page or self.page).evaluate(
            """() => [...document.querySelectorAll('table[data-role="peaks"] tbody tr')].map(
                 (row) => [...row.querySelectorAll('td')].map((cell) => Number(cell.dataset.value)))"""
        )
        return np.array(rows)

    def set_gain(self, value: str) -> None:
        self.page.locator(GAIN).fill(value)
        self.page.locator(GAIN).press("Enter")


@pytest.fixture
def hand(browser, address):
    hand = Hand(browser, address)
    yield hand
    hand.context.close()
    assert not hand.troubles


def peaks_of(*overrides: str, scenario: str = "he2017") -> np.ndarray:
    result = dampen.simulate(dampen.read_scenario(scenario, overrides))
    return np.stack([error_peaks(result, port) for port in result.scenario.ports], axis=1)


def test_a_changed_gain_changes_the_peaks_to_those_of_the_api(hand):
    np.testing.assert_array_equal(hand.peaks(), peaks_of())
    hand.after(lambda: hand.set_gain("2.5"))
    np.testing.assert_array_equal(hand.peaks(), peaks_of("controller.alpha_4=2.5"))


def test_a_slider_runs_the_value_that_it_shows(hand):
    hand.after(lambda: hand.page.locator(SLIDER).fill("700"))
    value = hand.page.locator(GAIN).input_value()
    assert float(value) != 1.0
    np.testing.assert_array_equal(hand.peaks(), peaks_of(f"controller.alpha_4={value}"))
    assert value in hand.page.locator(SLIDER).get_attribute("aria-valuetext")


def test_a_value_that_is_typed_is_run_to_its_last_digit(hand):
    hand.after(lambda: hand.set_gain("1.2345678901"))
    np.testing.assert_array_equal(hand.peaks(), peaks_of("controller.alpha_4=1.2345678901"))


def test_the_review_says_what_the_api_says(hand):
    hand.wait(hand.page, "reviewed", 0)
    verdicts = hand.page.locator("#verdicts")
    expect(verdicts).to_contain_text("14 of 17 claims hold in this run")
    expect(verdicts).to_contain_text("30 of 36 findings of the audit hold")


def test_undo_and_redo(hand):
    hand.after(lambda: hand.set_gain("3"))
    hand.after(lambda: hand.set_gain("4"))
    hand.after(lambda: hand.page.keyboard.press("Escape") or hand.page.get_by_role("button", name="Undo").click())
    np.testing.assert_array_equal(hand.peaks(), peaks_of("controller.alpha_4=3"))
    hand.after(lambda: hand.page.get_by_role("button", name="Undo").click())
    np.testing.assert_array_equal(hand.peaks(), peaks_of())
    expect(hand.page.locator(GAIN)).to_have_value("1")
    hand.after(lambda: hand.page.get_by_role("button", name="Redo").click())
    np.testing.assert_array_equal(hand.peaks(), peaks_of("controller.alpha_4=3"))


def test_a_pinned_run_stays_beside_what_comes_and_can_be_swapped(hand):
    hand.page.get_by_role("button", name="Pin", exact=True).click()
    hand.after(lambda: hand.set_gain("5"))
    legend = hand.page.locator("#panels .legend").first
    expect(legend).to_contain_text("he2017")
    hand.after(lambda: hand.page.get_by_role("button", name="Swap").click())
    np.testing.assert_array_equal(hand.peaks(), peaks_of())
    expect(legend).to_contain_text("alpha_4")
    hand.page.get_by_role("button", name="Unpin").click()
    expect(hand.page.get_by_role("button", name="Unpin")).to_be_hidden()
    expect(legend).not_to_contain_text("alpha_4")


def test_the_uncontrolled_beam_is_one_button_away(hand):
    hand.page.get_by_role("button", name="Beside no control").click()
    expect(hand.page.locator("#panels .legend").first).to_contain_text("no control")
    np.testing.assert_array_equal(hand.peaks(), peaks_of())


def test_scrubbing_shows_the_motion_of_that_time_and_trial(hand):
    page = hand.page
    trial = page.get_by_label("Number of the trial")
    trial.fill("3")
    trial.press("Enter")
    page.get_by_role("slider", name="Time", exact=True).fill("0.5")
    expect(page.locator("#transport")).to_contain_text("0.500 s")
    result = dampen.simulate(dampen.read_scenario("he2017"))
    shown = page.locator("#stage table tr").first.locator("td").first.inner_text()
    number, unit = shown.replace("\N{MINUS SIGN}", "-").split()
    factor = {"mm": 1e3, "µm": 1e6, "m": 1.0}[unit]
    digits = len(number.partition(".")[2])
    assert float(number) == pytest.approx(float(result["y"][3][500, 0]) * factor, abs=0.51 * 10**-digits)


def test_playing_goes_on_through_the_trials(hand):
    page = hand.page
    page.get_by_label("Speed").select_option("2")
    page.get_by_role("slider", name="Time", exact=True).fill("1.8")
    page.get_by_role("button", name="Play").click()
    expect(page.get_by_text("Trial 1 of 25")).to_be_visible()
    page.get_by_role("button", name="Pause").click()


def test_a_link_brings_everything_back(hand):
    hand.after(lambda: hand.set_gain("2.25"))
    hand.page.get_by_label("Number of the trial").fill("7")
    hand.page.get_by_label("Number of the trial").press("Enter")
    hand.page.get_by_role("button", name="Share").click()
    expect(hand.page.locator("#status")).to_contain_text("link")
    link = hand.page.evaluate("() => navigator.clipboard.readText()")
    assert link.startswith(hand.address)
    other = hand.open(link.removeprefix(hand.address))
    np.testing.assert_array_equal(hand.peaks(other), peaks_of("controller.alpha_4=2.25"))
    expect(other.locator(GAIN)).to_have_value("2.25")
    expect(other.get_by_label("Number of the trial")).to_have_value("7")


def test_a_broken_link_is_told_and_the_page_goes_on(hand):
    other = hand.open("/#s=nonsense")
    expect(other.get_by_role("alert")).to_contain_text("link")
    np.testing.assert_array_equal(hand.peaks(other), peaks_of())


def link_of(view: object, **changes: object) -> str:
    """A link as the page makes it, with a view of our own."""
    state = json.dumps({"v": 1, "preset": "he2017", "table": table_of("he2017"), "view": view, **changes}).encode()
    packer = zlib.compressobj(wbits=-15)
    return "/#s=" + base64.urlsafe_b64encode(packer.compress(state) + packer.flush()).decode().rstrip("=")


SENSELESS = ({"span": "foo"}, {"trial": -1}, {"trial": 1.5}, {"time": "x"}, {"speed": -1, "playing": True}, {"trial": None}, 7)


@pytest.mark.parametrize("view", SENSELESS)
def test_a_link_whose_view_has_no_sense_shows_its_scenario_all_the_same(browser, address, view):
    hand = Hand(browser, address, path=link_of(view))
    np.testing.assert_array_equal(hand.peaks(), peaks_of())
    hand.context.close()
    assert not hand.troubles


def test_a_run_of_another_scenario_says_so(hand):
    """After a refusal the last run stays, and nobody is to take it for the scenario's own."""
    page = hand.page
    expect(page.locator("#stage")).to_contain_text("he2017")
    hand.after(lambda: page.get_by_label("Scenario", exact=True).select_option("string-tip-mass"))
    expect(page.locator("#stage")).to_contain_text("string-tip-mass")
    page.locator('[data-path="controller.damping.tip_w"]').fill("-1")
    page.locator('[data-path="controller.damping.tip_w"]').press("Enter")
    expect(page.locator("#stage")).to_contain_text(re.compile("not this scenario", re.IGNORECASE))
    expect(page.locator("#status")).to_contain_text("Not run")


def test_walls_come_and_go_with_the_constraint(hand):
    page, stage = hand.page, hand.page.locator("#stage canvas")
    with_walls = stage.screenshot()
    hand.after(lambda: open_link(page, link_of({}, table={**table_of("he2017"), **WITHOUT_WALLS})))
    page.wait_for_timeout(500)
    assert stage.screenshot() != with_walls
    expect(page.locator("#stage")).not_to_contain_text("walls out of view")
    expect(page.locator("#panels")).to_contain_text("no constraint")
    hand.after(lambda: page.get_by_role("button", name="Undo").click())
    page.wait_for_timeout(500)
    expect(page.locator("#panels")).to_contain_text("constraint ±200 mm")


WITHOUT_WALLS = {"task": {"trials": 25, "trial_duration": 2.0}, "controller": {"kind": "none"}}


def open_link(page: Page, link: str) -> None:
    page.evaluate("(hash) => { location.hash = hash; }", link.removeprefix("/"))


def test_undoing_a_swap_brings_both_runs_back(hand):
    page = hand.page
    page.get_by_role("button", name="Pin", exact=True).click()
    hand.after(lambda: hand.set_gain("5"))
    hand.after(lambda: page.get_by_role("button", name="Swap").click())
    np.testing.assert_array_equal(hand.peaks(), peaks_of())
    hand.after(lambda: page.get_by_role("button", name="Undo").click())
    np.testing.assert_array_equal(hand.peaks(), peaks_of("controller.alpha_4=5"))
    legend = page.locator("#panels .legend").first
    expect(legend).to_contain_text("he2017")
    expect(legend).not_to_contain_text("alpha_4")


def test_an_error_stands_beside_its_field_and_the_last_run_stays(hand):
    before = hand.peaks()
    hand.set_gain("-1")
    error = hand.page.locator('[data-error="controller.alpha_4"]')
    expect(error).to_contain_text("must be > 0")
    expect(hand.page.locator(GAIN)).to_have_attribute("aria-invalid", "true")
    assert error.get_attribute("id") in hand.page.locator(GAIN).get_attribute("aria-describedby")
    np.testing.assert_array_equal(hand.peaks(), before)
    hand.after(lambda: hand.set_gain("2"))
    expect(error).to_be_empty()


def test_a_broken_scenario_is_refused_with_its_reason(hand, tmp_path):
    broken = tmp_path / "broken.toml"
    broken.write_text('[plant]\nkind = "timoshenko"\ntip_mass = -0.1\n')
    before = hand.peaks()
    hand.page.locator('input[type="file"][accept*=".toml"]').set_input_files(broken)
    expect(hand.page.locator("#status")).to_contain_text("plant.tip_mass must be >= 0 kg, but is -0.1")
    np.testing.assert_array_equal(hand.peaks(), before)
    hand.troubles[:] = [one for one in hand.troubles if "400" not in one]  # Chromium itself notes the refusal


def test_a_downloaded_result_opens_again_as_it_was(hand, tmp_path):
    hand.after(lambda: hand.set_gain("3.5"))
    before = hand.peaks()
    hand.page.get_by_role("button", name="Download").click()
    with hand.page.expect_download() as waiting:
        hand.page.get_by_role("button", name="Result (NetCDF)").click()
    path = tmp_path / waiting.value.suggested_filename
    waiting.value.save_as(path)
    assert path.suffix == ".nc"
    np.testing.assert_array_equal(before[:, 0], np.abs(dampen.load(path)["y"][:, :, 0]).max(axis=1))
    hand.after(lambda: hand.page.get_by_label("Scenario", exact=True).select_option("string-tip-mass"))
    hand.after(lambda: hand.page.locator('input[type="file"][accept*=".nc"]').set_input_files(path))
    np.testing.assert_array_equal(hand.peaks(), before)
    expect(hand.page.locator("#status")).to_contain_text("from a file")
    expect(hand.page.locator(GAIN)).to_have_value("3.5")


def test_a_downloaded_scenario_is_the_one_that_runs(hand, tmp_path):
    hand.after(lambda: hand.set_gain("0.75"))
    hand.page.get_by_role("button", name="Download").click()
    with hand.page.expect_download() as waiting:
        hand.page.get_by_role("button", name="Scenario (TOML)").click()
    waiting.value.save_as(tmp_path / "mine.toml")
    assert dampen.read_scenario(tmp_path / "mine.toml").controller.alpha_4 == 0.75


@pytest.mark.parametrize("name", list(shipped()))
def test_every_shipped_scenario_opens_and_runs(hand, name):
    if name != "he2017":
        hand.after(lambda: hand.page.get_by_label("Scenario", exact=True).select_option(name))
    np.testing.assert_array_equal(hand.peaks(), peaks_of(scenario=name))
    hand.wait(hand.page, "reviewed", 0)


def test_another_kind_brings_its_own_fields(hand):
    page = hand.page
    hand.after(lambda: page.locator('[data-path="controller.kind"]').select_option("none"))
    expect(page.locator(GAIN)).to_have_count(0)
    np.testing.assert_array_equal(hand.peaks(), peaks_of("controller.kind=none"))
    hand.after(lambda: page.get_by_role("button", name="Undo").click())
    expect(page.locator(GAIN)).to_have_value("1")


def test_keyboard_alone_is_enough(hand):
    page = hand.page
    page.keyboard.press("Tab")
    expect(page.locator(":focus")).to_have_text("Skip the controls")
    page.locator(SLIDER).focus()
    hand.after(lambda: page.keyboard.press("ArrowRight"))
    value = page.locator(GAIN).input_value()
    np.testing.assert_array_equal(hand.peaks(), peaks_of(f"controller.alpha_4={value}"))
    page.locator("#stage").focus()
    page.keyboard.press("]")
    expect(page.get_by_text("Trial 1 of 25")).to_be_visible()
    page.keyboard.press(" ")
    expect(page.get_by_role("button", name="Pause")).to_be_visible()
    page.keyboard.press(" ")
    hand.after(lambda: page.keyboard.press("Control+z"))
    np.testing.assert_array_equal(hand.peaks(), peaks_of())


def test_every_control_is_reached_by_tab_in_the_order_of_the_page_and_shows_its_focus(hand):
    page, seen = hand.page, []
    for _ in range(60):
        page.keyboard.press("Tab")
        found = page.evaluate(
            """() => { const e = document.activeElement, s = getComputedStyle(e), r = e.getBoundingClientRect();
              return [e.tagName, e.getAttribute('aria-label') || e.labels?.[0]?.innerText || e.innerText || e.id,
                      s.outlineStyle !== 'none' || s.boxShadow !== 'none', r.width > 0 && r.height > 0]; }"""
        )
        seen.append(found)
    named = [one for one in seen if one[0] in ("INPUT", "SELECT", "BUTTON", "A", "SUMMARY")]
    assert len({str(one[1]) for one in named}) > 30
    assert all(label for _, label, _, _ in named), named
    assert all(outlined for _, _, outlined, _ in named), [one for one in named if not one[2]]


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("viewport", [DESKTOP, PHONE], ids=["desktop", "phone"])
def test_axe_finds_nothing_serious(browser, address, viewport, scheme):
    hand = Hand(browser, address, viewport, scheme)
    hand.wait(hand.page, "reviewed", 0)
    if viewport is PHONE:
        for tab in ("Panels", "Controls"):
            hand.page.get_by_role("tab", name=tab).click()
            check_axe(hand.page)
    else:
        check_axe(hand.page)
        hand.set_gain("-1")
        hand.page.evaluate("() => document.querySelectorAll('details').forEach((fold) => { fold.open = true; })")
        expect(hand.page.locator('[data-error="controller.alpha_4"]')).to_contain_text("must be")
        check_axe(hand.page)
    hand.context.close()
    assert not hand.troubles


def check_axe(page: Page) -> None:
    """Nothing serious or critical, by axe-core."""
    found = Axe().run(page).response["violations"]
    serious = [v for v in found if v["impact"] in ("serious", "critical")]
    bad = [(v["id"], [node["html"][:150] for node in v["nodes"][:3]]) for v in serious]
    assert not bad


@pytest.mark.parametrize("name", ["he2017", "assembled-from-fe", "flexible-arm-point-to-point"])
def test_nothing_overflows_a_phone(browser, address, name):
    hand = Hand(browser, address, PHONE)
    if name != "he2017":
        hand.after(lambda: hand.page.get_by_label("Scenario", exact=True).select_option(name))
    for tab in ("Panels", "Controls"):
        hand.page.get_by_role("tab", name=tab).click()
        widths = hand.page.evaluate("() => [document.documentElement.scrollWidth, innerWidth]")
        assert widths[0] <= widths[1], (tab, widths)
    hand.context.close()
    assert not hand.troubles


def test_colours_can_be_chosen_and_are_kept(hand):
    page = hand.page
    page.get_by_label("Colours").select_option("dark")
    dark = page.evaluate("() => getComputedStyle(document.body).backgroundColor")
    other = hand.open("/")
    assert other.evaluate("() => getComputedStyle(document.body).backgroundColor") == dark
    assert sum(map(int, re.findall(r"\d+", dark)[:3])) < 150


def test_the_stage_is_drawn(hand):
    """Not one colour all over: a beam, its walls and its arrows are there."""
    picture = hand.page.locator("#stage canvas").screenshot()
    assert len(picture) > 4000
