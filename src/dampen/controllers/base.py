"""What every controller hands on: for each trial the law at the ports, and what it learns from the trial."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, NamedTuple

import numpy as np

from dampen.family import Family
from dampen.modal import ModalModel
from dampen.port import Port
from dampen.stage import Stage

Array = np.ndarray
Memory = Mapping[str, Array]
Assumption = Literal["alignment", "equal starts", "repetition", "bounds", "moving ports"]
SampledStep = Callable[[Any, Array, Array, Array], None]


@dataclass(frozen=True)
class Setting:
    """What a controller may know of its task.

    ports, length: of the structure.   steps, dt: the intervals at which the law acts, those of the simulation, or its samples.
    reference, low, high: (steps + 1, ports) what the ports are to follow in the trial ahead, and the limits of the tracking
    error e = y - reference.   bounds: by port name [N, N m], and "f" for the distributed load [N/m]; as stated in the scenario,
    true or not.   gains: (ports,) slope of each port's stages in full motion, what a unit of command delivers; 0 where there
    is no actuator.   lags: for each port the time constants of its stages [s].   sampled: whether the law acts through samples,
    whose commands arrive `delay` [s] later.
    model: the structure's modes.   response: (steps, ports, ports) the tracking error at the ends of the intervals, by port,
    after a unit of feedforward in the first interval, by port, with the law's own feedback at work; both computed when asked.
    kept: what a controller has worked out from all this and wants to find again in the run's next trial.
    """

    ports: tuple[Port, ...]
    steps: int
    dt: float
    length: float
    reference: Array
    low: Array
    high: Array
    bounds: Mapping[str, float]
    gains: Array = field(default_factory=lambda: np.ones(1))
    lags: tuple[tuple[float, ...], ...] = ()
    sampled: bool = False
    delay: float = 0.0
    model: Callable[[], ModalModel] = field(default=lambda: _unknown())
    response: Callable[[], Array] = field(default=lambda: _unknown())
    kept: dict[str, Any] = field(default_factory=dict, compare=False, repr=False)

    @property
    def times(self) -> Array:
        """(steps,) when the law acts: at its samples, or at the middle of each step [s]."""
        return (np.arange(self.steps) + (0.0 if self.sampled else 0.5)) * self.dt

    def by_port(self, values: Mapping[str, float], default: float = 0.0) -> Array:
        """(ports,) numbers that were given by port name."""
        return np.array([values.get(port.name, default) for port in self.ports])

    def by_kind(self, force: float, torque: float) -> Array:
        """(ports,) one number for force ports, another for torque ports."""
        return np.array([force if port.kind == "force" else torque for port in self.ports])


def named(**tables: Mapping[str, Any]) -> Mapping[str, str]:
    """What `ports_named` says of parameters that are tables with ports as keys."""
    return {f"{table}.{port}": port for table, given in tables.items() for port in given}


def total(terms: Mapping[str, PortLaw]) -> PortLaw:
    """The law that is the sum of these terms: one at least."""
    first, *rest = terms.values()
    return sum(rest, start=first)


def _unknown() -> Any:
    raise RuntimeError("This setting has no model.")


# The parts of a law at the ports, and what they are called where a law is taken apart.
LAW = {"feedforward": "feedforward", "coulomb": "Sgn", "damping": "damping", "stiffness": "stiffness", "barrier": "barrier"}


@dataclass(frozen=True)
class PortLaw:
    """The monotone law at the ports for one trial, with e = y - reference and v its rate,

        u in feedforward - damping v - coulomb Sgn(v) - stiffness e - barrier dV/de

    feedforward, coulomb: (steps, ports).   damping, stiffness, barrier: (ports,).   All but feedforward must be >= 0.
    V is the barrier of the controller's `barrier_shape`, for the log barrier V(e) = 1/4 ln^2(C^2 / (C^2 - e^2)).
    """

    feedforward: Array
    coulomb: Array = None  # type: ignore[assignment]  # zeros from then on
    damping: Array = None  # type: ignore[assignment]  # zeros from then on
    stiffness: Array = None  # type: ignore[assignment]  # zeros from then on
    barrier: Array = None  # type: ignore[assignment]  # zeros from then on

    def __post_init__(self) -> None:
        shape = np.shape(self.feedforward)
        steps, ports = shape if len(shape) == 2 else (0, 0)  # a wrong shape is told where the law is used
        for name in ("coulomb", "damping", "stiffness", "barrier"):
            if getattr(self, name) is None:
                object.__setattr__(self, name, np.zeros((steps, ports) if name == "coulomb" else ports))

    def __add__(self, other: PortLaw) -> PortLaw:
        """Both laws at once."""
        return PortLaw(*(getattr(self, part) + getattr(other, part) for part in LAW))

    @property
    def split(self) -> dict[str, PortLaw]:
        """The law's own parts, those that are not zero, each as a law by itself."""
        nothing = np.zeros(np.shape(self.feedforward))
        found = {LAW[part]: getattr(self, part) for part in LAW if np.any(getattr(self, part))}
        parts = {name: part for part, name in LAW.items()}
        return {name: PortLaw(**{"feedforward": nothing, parts[name]: value}) for name, value in found.items()}


@dataclass(frozen=True)
class Trial:
    """What a controller gets to see of a finished trial, as it measured it: tracking error (steps + 1, ports), its rate v and
    the command (steps, ports)."""

    index: int
    error: Array
    v: Array
    command: Array


class SampledLoop(NamedTuple):
    """The closed loop of a linear sampled law around all modes of the structure, from sample to sample, x+ = matrix x.

    x: q of all modes, q' of all modes, the output of every actuator's lag, then what the law keeps: best the errors of its
    estimates, so that what belongs to the structure and what to the observer stand apart. known: how many of the lowest modes
    the law is designed on. lags: how many lags are in x, of those in `Setting.lags`.
    """

    matrix: Array
    known: int
    lags: int = 0


class Controller(Family):
    """A law at the ports (inner loop) and what it learns between trials (outer loop). Memories are (steps, ports) arrays.

    paper: the one whose law this is, "He et al. 2017": a comparison says how it fares. "": none.
    """

    paper: ClassVar[str] = ""

    @property
    def barrier_shape(self) -> Literal["log", "tan", "none"]:
        """The barrier that the law relies on, and for which the tip must start inside the constraint."""
        return "none"

    def has_barrier(self, port: Port) -> bool:
        """Whether that barrier acts at a port."""
        return self.barrier_shape != "none"

    @property
    def relies_on(self) -> tuple[Assumption, ...]:
        """What the proof behind the law takes for granted, for an audit to look at."""
        return ()

    @property
    def needs_bounds(self) -> tuple[str, ...]:
        """Which of the stated bounds the law relies on: "f" for the load, "ports" for the ports."""
        return ()

    def ports_named(self) -> Mapping[str, str]:
        """The ports that its parameters name: "stiffness.tip_w" -> "tip_w", for every table that goes by port."""
        return {}

    def search(self, setting: Setting) -> Mapping[str, str]:
        """Where a tuner is to look for gains: by path below `controller`, a range "LOW:HIGH" or "LOW:HIGH:log".

        {"damping.tip_w": "0.01:100:log"} for a gain in a table by port. Ranges that have units should follow from the
        structure; see `dampen.controllers.scales`. Ports without an actuator have no gains. {}: nothing to tune.
        """
        return {}

    def design_time(self, trials: int, steps: int, ports: int) -> float:
        """About how long the law itself computes in a run [s], for who must refuse what takes too long; 0: hardly anything."""
        return 0.0

    def notes(self, setting: Setting) -> list[str]:
        """What the user should know before the run, one line each."""
        return []

    def sampled_loop(self, setting: Setting) -> SampledLoop | None:
        """The loop that a law of samples makes with the structure, `setting.model()`; None: it is not linear, or does not say.

        A law that acts port by port need not say: its loop is known from `law`.
        """
        return None

    def compensation(self, port: Port) -> tuple[Stage, ...]:
        """Stages between the law's value and the actuator's input: the controller's own idea of the actuator."""
        return ()

    def begin(self, setting: Setting) -> Memory:
        """The memories before trial 0."""
        return {}

    @abstractmethod
    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        """The law of the coming trial."""

    def terms(self, memory: Memory, setting: Setting) -> Mapping[str, PortLaw]:
        """The law of the coming trial as a sum of named terms: what can be left out to see what it is worth.

        By default the parts of `law` that are not zero; override where two terms act through one part.
        """
        return self.law(memory, setting).split

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        """The memories after a trial."""
        return memory


class SampledFeedback(Controller):
    """A law that acts through samples alone, all ports together: one `step` function, in plain Python over scalars.

    `step(sample, state, parameters, command)` reads the sample (see `dampen.simulation.digital.Sample`: arrays by port of
    error, rate, reference, feedforward, ...), keeps what it wants in `state`, and writes `command`, one number for each port.
    The library compiles that very function.
    """

    step: ClassVar[SampledStep]

    @abstractmethod
    def row(self, setting: Setting) -> Array:
        """The parameters that `step` reads, in its order."""

    def states(self, setting: Setting) -> int:
        """How many numbers `step` keeps from sample to sample."""
        return 0

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return PortLaw(np.zeros((setting.steps, len(setting.ports))))
