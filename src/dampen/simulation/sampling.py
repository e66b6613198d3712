"""How the law acts through samples: period, delay, noise, quantiser, estimated rates, and what becomes of Sgn."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Literal

from annotated_types import Ge, Gt, Lt, Unit
from typing_extensions import Doc

from dampen.component import Component


@dataclass(frozen=True)
class Sampling(Component):
    """A digital controller around the law; used with `numerics.mode = "sampled"`.

    Noise, quantiser, layers, command limits and nominal compliances are given by port.
    """

    period: Annotated[float, Gt(0), Unit("s"), Doc("sample period; a multiple of the time step that divides the trial")] = 0.001
    delay: Annotated[float, Ge(0), Unit("s"), Doc("from a sample until its command acts; a multiple of the time step")] = 0.0
    noise: Annotated[dict[str, float], Ge(0), Unit("m, rad"), Doc("by port, standard deviation of the sensor's noise")] = field(
        default_factory=dict
    )
    quantum: Annotated[dict[str, float], Ge(0), Unit("m, rad"), Doc("by port, step of the sensor's quantiser")] = field(
        default_factory=dict
    )
    seed: Annotated[int, Ge(0), Doc("seed of the noise")] = 0
    rate: Annotated[
        Literal["difference", "observer"], Doc("the rate comes from a filtered difference of samples, or from an observer")
    ] = "difference"
    filter_time: Annotated[float, Ge(0), Unit("s"), Doc("time constant of the difference's filter; 0: none")] = 0.002
    observer_bandwidth: Annotated[float, Gt(0), Unit("Hz"), Doc("where the observer's two poles lie")] = 50.0
    switching: Annotated[
        Literal["explicit", "boundary-layer", "implicit"], Doc("what becomes of Sgn: as it is, smoothed, or solved for")
    ] = "explicit"
    layer: Annotated[
        dict[str, float], Gt(0), Unit("m/s, rad/s"), Doc("by port, half-width of the boundary layer; left out: 0.01")
    ] = field(default_factory=dict)
    compliance: Annotated[
        dict[str, float],
        Gt(0),
        Unit("m/(s N), rad/(s N m)"),
        Doc("by port, nominal compliance; left out: from the model"),
    ] = field(default_factory=dict)
    barrier_edge: Annotated[float, Gt(0), Lt(1), Doc("share of the constraint at which the barrier's command ends")] = 0.99
    command_limit: Annotated[dict[str, float], Gt(0), Unit("N, N m"), Doc("by port, largest command; left out: none")] = field(
        default_factory=dict
    )

    @property
    def by_port(self) -> dict[str, dict[str, float]]:
        """The parameters that go by port."""
        return {name: getattr(self, name) for name in ("noise", "quantum", "layer", "compliance", "command_limit")}
