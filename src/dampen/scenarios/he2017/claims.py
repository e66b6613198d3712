"""The claims of He et al. 2017, section V and Theorems 1 and 2, measured on a run."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dampen.analysis.audit.boundedness import bounded, late_trials, signals
from dampen.analysis.claims import Claim
from dampen.analysis.composite_energy import LAMBDAS, CompositeEnergy, composite_energy, rises
from dampen.analysis.metrics import field_rms, fraction_of_limit, largest, peaks, port_rms
from dampen.simulation.result import Result

Composite = CompositeEnergy | None
KEPT, RESIDUAL, GROWTH = 0.5, 0.03, 1.05
CHANNELS = (("w", "tip_w", "w", "m", "N"), ("phi", "tip_phi", "phi", "rad", "N m"))


def he2017_claims(result: Result, baseline: Result) -> list[Claim]:
    """All rows; `baseline` is the same run without control."""
    composite = composite_energy(result)
    return [
        *_without_control(baseline),
        *_fields_settle(result),
        *_constraint_kept(result),
        *_peaks_fall(result),
        *_inputs_bounded(result),
        *_theorem_1(result, composite),
        *_theorem_2(result, baseline, composite),
    ]


def _without_control(baseline: Result) -> Iterator[Claim]:
    last = baseline.trials - 1
    for id, (field, *_) in zip(("F5", "F6"), CHANNELS, strict=True):
        ratio = _ratio(field_rms(baseline, field, last), field_rms(baseline, field, 0))
        yield Claim(
            id, f"Without control {field}(x, t) keeps vibrating", "RMS of the last trial >= 50 % of trial 0's",
            f"{ratio:.0%}", None if last < 1 else ratio >= KEPT,
        )  # fmt: skip
    peak, limit = largest(baseline, "y", "tip_w").max(), upper_limits(baseline)[0]
    exceeds = bool(peak > limit) if np.isfinite(limit) else None
    yield Claim("F7", "Without control |w(L, t)| exceeds C1", f"max |w(L, t)| > {limit:g} m", f"{peak:.4f} m", exceeds)
    least = min(port_rms(baseline, "tip_phi", j) for j in range(baseline.trials))
    ratio = _ratio(least, port_rms(baseline, "tip_phi", 0))
    yield Claim(
        "F8", "Without control phi(L, t) does not converge", "RMS of no trial < 50 % of trial 0's",
        f"least: {ratio:.0%}", None if last < 1 else ratio >= KEPT,
    )  # fmt: skip


def _fields_settle(result: Result) -> Iterator[Claim]:
    for id, (field, *_) in zip(("F9", "F10"), CHANNELS, strict=True):
        peak = peaks(result, field)
        yield Claim(
            id, f"With the law {field}(x, t) goes to zero as time goes on", "peak of the last trial <= 3 % of trial 0's",
            f"{_ratio(peak[-1], peak[0]):.2%}", None if result.trials < 2 else bool(peak[-1] <= RESIDUAL * peak[0]),
        )  # fmt: skip


def _constraint_kept(result: Result) -> Iterator[Claim]:
    for id, (_, port, name, unit, _), limit in zip(("F11", "F12"), CHANNELS, upper_limits(result), strict=True):
        y = largest(result, "y", port).max()
        yield Claim(
            id, f"|{name}(L, t)| stays below its constraint", f"|{name}(L, t)| < {limit:g} {unit} at every step",
            f"max {y:.4f} {unit}{_so_far(result)}", _kept(result, port),
        )  # fmt: skip


def upper_limits(result: Result) -> np.ndarray:
    """(ports,) C1 and C2; inf where there is none."""
    return np.asarray(result.scenario.limits()[1][0])


def _kept(result: Result, *ports: str) -> bool | None:
    """Whether |y|/C stayed below 1; a motion that diverged did not keep it, and without a constraint nothing can be said."""
    if not np.isfinite(upper_limits(result)).all():
        return None
    return all(fraction_of_limit(result, port).max() < 1 for port in ports) and result.status != "diverged"


def _so_far(result: Result) -> str:
    return "" if not result.broke_off else f" in {result.trials} of {result.scenario.task.trials} trials"


def _peaks_fall(result: Result) -> Iterator[Claim]:
    rows = (("F13", "w", max(1, result.trials - 5), "along the trials", "the last five trials"),
            ("F14", "phi", 15, "within 15 trials", "trials 15 and later"))  # fmt: skip
    for id, field, start, when, which in rows:
        peak = peaks(result, field)
        late = peak[start:]
        short = len(late) == 0 or (id == "F13" and result.trials < 6)
        measured = "too few trials" if short else f"{_ratio(late.max(), peak[0]):.2%}"
        yield Claim(
            id, f"max |{field}| falls to zero {when}", f"peaks of {which} <= 3 % of trial 0's",
            measured, None if short else bool(late.max() <= RESIDUAL * peak[0]),
        )  # fmt: skip


def _inputs_bounded(result: Result) -> Iterator[Claim]:
    for id, (_, port, _, _, unit) in zip(("F15", "F16"), CHANNELS, strict=True):
        top, late = _trend(largest(result, "delivered", port))
        what = "force B(u_0)" if port == "tip_w" else "torque B(tau_0)"
        yield Claim(
            id, f"The delivered {what} stays bounded", "last five trials <= 105 % of those before",
            f"max {top:.3g} {unit}; last five: {late:.0%}" if late is not None else f"max {top:.3g} {unit}",
            None if late is None else bool(np.isfinite(top) and late <= GROWTH),
        )  # fmt: skip


def _theorem_1(result: Result, composite: Composite) -> Iterator[Claim]:
    rows = [bounded(*signal) for signal in signals(result)]
    if composite is not None:
        rows.append(bounded("E_j(T_b)", "", composite.total[:, 0], "J"))
    growing = [finding.id.removeprefix("bounded.") for finding in rows if finding.verdict == "FAIL"]
    measured = f"{len(rows)} signals: " + (f"growing: {', '.join(growing)}" if growing else "none grows")
    yield Claim(
        "T1", "Every signal, and E_j(t), is bounded in every trial",
        f"largest of the last {late_trials(result.trials)} trials <= 105 % of those before",
        measured, None if all(finding.verdict == "n/a" for finding in rows) else not growing,
    )  # fmt: skip


def _theorem_2(result: Result, baseline: Result, composite: Composite) -> Iterator[Claim]:
    listed = ", ".join(f"{value:g}" for value in LAMBDAS)
    for id, energy, how in (
        ("T2a", None if composite is None else composite.printed, "the jump of its weight left out, as in (46)"),
        ("T2b", None if composite is None else composite.total, "the jump of its weight counted"),
    ):
        count = None if energy is None else rises(energy)
        measured = "not this law" if count is None else "rises: " + ", ".join(str(n) for n in count)
        yield Claim(
            id, f"E_j(T_b) does not increase along the trials; {how}", f"no rise at lambda = {listed} 1/s",
            measured, None if count is None or result.trials < 2 else not any(count),
        )  # fmt: skip
    ports = [port for _, port, *_ in CHANNELS]
    fraction = max(fraction_of_limit(result, port).max() for port in ports)
    measured = f"largest |y|/C {fraction:.3f}{_so_far(result)}"
    yield Claim("T2c", "The outputs keep the constraint", "|y| < C at every step", measured, _kept(result, *ports))
    last = min(result.trials, baseline.trials) - 1
    left = max(_ratio(field_rms(result, field, last), field_rms(baseline, field, last)) for field, *_ in CHANNELS)
    yield Claim(
        "T2d", "f, d_w and d_phi are rejected", "RMS of both fields in the last trial <= 3 % of those without control",
        f"{left:.2%}", None if last < 1 else bool(left <= RESIDUAL),
    )  # fmt: skip


def _trend(per_trial: np.ndarray) -> tuple[float, float | None]:
    """The largest value of all trials, and that of the last five relative to that of the trials before."""
    top = float(per_trial.max())
    if len(per_trial) < 10:
        return top, None
    return top, _ratio(float(per_trial[-5:].max()), float(per_trial[:-5].max()))


def _ratio(a: float, b: float) -> float:
    """a / b where 0 / 0 is 1 (nothing changed) and anything else over 0 is inf."""
    return a / b if b else 1.0 if a == 0 else float("inf")
