"""The plant of a scenario as a state-space model of python-control."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from dampen.arguments import TRUTH, takes
from dampen.component import LEAST, MOST, ArgumentError, is_number, wrong
from dampen.export.balanced import balanced as truncated
from dampen.export.linear import LinearModel, Source, linear_model
from dampen.export.names import distinct
from dampen.simulation.scenario import Scenario

if TYPE_CHECKING:
    import control


def plant_model(
    scenario: Scenario,
    modes: int | None = None,
    *,
    inputs: Sequence[Source] = ("ports",),
    rates: bool = False,
    residual: bool = False,
    balanced: int | None = None,
    discrete: bool | float = False,
) -> LinearModel:
    """The matrices of :func:`state_space`, for which python-control is not needed."""
    if not isinstance(scenario, Scenario):
        raise wrong("scenario", "be a Scenario, as `dampen.read_scenario` makes them", scenario)
    model = linear_model(scenario, modes, inputs=inputs, rates=rates, residual=residual, dt=sample_time(scenario, discrete))
    return model if balanced is None else truncated(model, balanced)[0]


def sample_time(scenario: Scenario, discrete: bool | float) -> float:
    """The time from sample to sample [s]; 0: continuous."""
    if isinstance(discrete, bool | np.bool_):
        return scenario.numerics.step if discrete else 0.0
    if not (is_number(discrete) and discrete > 0):
        raise wrong("discrete", "be true, false or a time step > 0 s", discrete)
    if not LEAST <= discrete <= MOST:
        raise wrong("discrete", f"be a time step from {LEAST:g} to {MOST:g} s", discrete)
    return float(discrete)


@takes(rates=TRUTH, residual=TRUTH)
def state_space(
    scenario: Scenario,
    modes: int | None = None,
    *,
    inputs: Sequence[Source] = ("ports",),
    rates: bool = False,
    residual: bool = False,
    balanced: int | None = None,
    discrete: bool | float = False,
) -> control.StateSpace:
    """The scenario's plant as a `control.StateSpace`: forces at the ports in, displacements at the ports out.

    The signals are named after the ports, `tip_w_force` [N] -> `tip_w` [m]; the states are `q_1`, ..., `q_1_rate`, ... of the
    mass-normalised modes, damped as the plant is. Actuators, disturbance and controller are not in it.

    modes:    how many of the lowest modes; left out: as many as the scenario computes with.
    inputs:   "ports"; also "base", the acceleration of the base, and "modal", the modal forces of a distributed load.
    rates:    the ports' rates as outputs too.
    residual: the static compliance of the modes left out as feedthrough, so that few modes are right far below the next one.
    balanced: number of states to keep of those by balanced truncation; every mode must be damped.
    discrete: True: at the scenario's own time steps; a number: at these [s]; exact for inputs held in between.

    Needs python-control: `pip install 'dampen[export]'`. Raises ArgumentError without it, and for what the plant does not have.
    """
    try:
        import control
    except ImportError:
        raise ArgumentError("A state-space object needs python-control: pip install 'dampen[export]'.") from None
    model = plant_model(
        scenario, modes, inputs=inputs, rates=rates, residual=residual, balanced=balanced, discrete=discrete
    )  # fmt: skip
    named = {
        key: distinct([name.replace(".", "_") for name, _ in getattr(model, key)]) for key in ("states", "inputs", "outputs")
    }
    return control.StateSpace(model.a, model.b, model.c, model.d, model.dt, name="plant", remove_useless_states=False, **named)
