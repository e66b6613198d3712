"""Linear-quadratic-Gaussian control on a reduced modal model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar, NamedTuple

import numpy as np
from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError
from dampen.controllers.base import Array, SampledFeedback, SampledLoop, SampledStep, Setting, named
from dampen.controllers.sampled_plant import sampled_model, transition, under_way
from dampen.controllers.scales import elastic, scales, span
from dampen.modal import ModalModel

UNASKED = 1e-12  # weight at rest of a port that nobody asked to be anywhere


def lqg_step(sample, state, parameters, command):  # type: ignore[no-untyped-def]
    """Correct the estimate by the reading, command from it, predict the next."""
    ports, n = len(command), int(parameters[0])
    hold, feed, correct, read = 1, 1 + ports * n, 1 + ports * n + ports * ports, 1 + 2 * ports * n + ports * ports
    drift, push = 1 + 3 * ports * n + ports * ports, 1 + 3 * ports * n + ports * ports + n * n
    for p in range(ports):
        surprise = sample.error[p] + sample.reference[p]
        for i in range(n):
            surprise -= parameters[read + p * n + i] * state[i]
        state[n + p] = surprise
    for i in range(n):
        for p in range(ports):
            state[i] += parameters[correct + i * ports + p] * state[n + p]
    for p in range(ports):
        command[p] = 0.0
        for r in range(ports):
            command[p] += parameters[feed + p * ports + r] * sample.reference[r]
        for i in range(n):
            command[p] -= parameters[hold + p * n + i] * state[i]
    for i in range(n):
        state[n + ports + i] = state[i]
    for i in range(n):
        state[i] = 0.0
        for r in range(n):
            state[i] += parameters[drift + i * n + r] * state[n + ports + r]
        for p in range(ports):
            state[i] += parameters[push + i * ports + p] * command[p]


class Design(NamedTuple):
    """x+ = A x + B u, y = C x at the samples; u = feed r - hold x, x <- x + correct (y - C x). x: q, q', commands under way."""

    a: Array
    b: Array
    c: Array
    hold: Array
    correct: Array
    feed: Array


@dataclass(frozen=True)
class LQG(SampledFeedback):
    """Linear-quadratic-Gaussian control of the lowest modes, through samples: a Kalman filter and its state fed back.

        hold minimises the sum over samples of  energy_weight (q'^2 + omega^2 q^2) + error_weight y^2 + effort_weight u^2
        the filter is optimal for white forces of `force_noise` at the ports, held from sample to sample, and for white
        `sensor_noise` on the readings

    A delay is part of the model, and so is the slope of the actuators in full motion. A reference is fed forward so that the
    model comes to rest on it. What the model leaves out is not seen by the design: spillover shows in the run. Source:
    Franklin, Powell and Workman, Digital Control of Dynamic Systems, 1998, ch. 9.
    """

    kind: ClassVar[str] = "lqg"
    step: ClassVar[SampledStep] = staticmethod(lqg_step)

    modes: Annotated[int, Gt(0), Doc("number of modes in the controller's model")] = 6
    energy_weight: Annotated[float, Ge(0), Unit("1/J"), Doc("weight of the modal energies")] = 1.0
    error_weight: Annotated[dict[str, float], Ge(0), Unit("1/m^2, 1/rad^2"), Doc("by port, weight of its displacement")] = field(
        default_factory=dict
    )
    effort_weight: Annotated[float, Gt(0), Unit("1/N^2, 1/(N m)^2"), Doc("weight of the commands")] = 0.1
    force_noise: Annotated[float, Gt(0), Unit("N, N m"), Doc("assumed standard deviation of the disturbing forces")] = 0.1
    sensor_noise: Annotated[float, Gt(0), Unit("m, rad"), Doc("assumed standard deviation of the readings")] = 1e-4

    def ports_named(self) -> Mapping[str, str]:
        return named(error_weight=self.error_weight)

    def design_time(self, trials: int, steps: int, ports: int) -> float:
        """Of the Riccati equations, as measured."""
        return 3.7e-6 * self.modes**3

    def search(self, setting: Setting) -> Mapping[str, str]:
        """How many modes; the effort's weight, such that the cheapest and the dearest command damp a port by a thousand and a
        hundredth of its impedance; weights of all ports' displacements against their static stiffness; the sensors' noise
        against what the assumed force moves at rest. The energy's weight and the force's noise stay, and the ranges are in
        units of these: only ratios count."""
        acting = scales(setting)
        if not acting:
            return {}
        b = setting.model().b[:, : self.modes]
        square = {port.name: float(np.mean(b[p] ** 2)) for p, port in enumerate(setting.ports)}
        damped = float(np.exp(np.mean([np.log(square[s.port.name] * s.impedance**2) for s in acting])))
        soft = float(np.exp(np.mean([-np.log(s.stiffness) for s in acting])))
        energy, (omega, shapes) = self.energy_weight or 1.0, elastic(setting)
        give = np.sum((shapes / omega) ** 2, axis=1)
        found = {f"error_weight.{p.name}": span(energy / c, 1e-2, 1e4) for p, c in zip(setting.ports, give, strict=True) if c > 0}
        most = min(12, setting.model().count)
        found |= {"modes": f"2:{most}"} if most > 2 else {}
        found["effort_weight"] = span(energy / damped, 1e-6, 1e4)
        return {**found, "sensor_noise": span(self.force_noise * soft, 1e-5, 1)}

    def row(self, setting: Setting) -> Array:
        d = self.design(setting)
        blocks = (d.hold, d.feed, d.correct, d.c, d.a, d.b)
        return np.concatenate([[float(len(d.a))], *(np.ravel(block) for block in blocks)])

    def states(self, setting: Setting) -> int:
        n = 2 * min(self.modes, setting.model().count) + under_way(setting) * len(setting.ports)
        return 2 * n + len(setting.ports)

    def design(self, setting: Setting) -> Design:
        """The sampled model and its gains. Raises ArgumentError where the Riccati equations have no solution."""
        from scipy.linalg import LinAlgError, solve_discrete_are

        a, b, c = sampled_model(self.lowest(setting.model()), setting)
        omega, ports = setting.model().omega[: self.modes], len(setting.ports)
        n = len(omega)
        weight = np.zeros_like(a)
        weight[: 2 * n, : 2 * n] = self.energy_weight * np.diag(np.concatenate([omega**2, np.ones(n)]))
        weight += c.T @ (setting.by_port(self.error_weight)[:, None] * c)
        shaking, one = self._shaking(setting, len(a)), np.eye(ports)
        none = "Argument `controller` has weights for which there is no LQG design"
        try:
            with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # what comes of it is checked
                # only ratios count: in units of the effort's weight and of the sensors' noise, however small these are
                cost = solve_discrete_are(a, b, weight / self.effort_weight, one)
                spread = solve_discrete_are(a.T, c.T, np.square(self.force_noise / self.sensor_noise) * shaking, one)
                hold = np.linalg.solve(one + b.T @ cost @ b, b.T @ cost @ a)
                correct = np.linalg.solve(c @ spread @ c.T + one, c @ spread).T
                rest, feed = at_rest(a, b, c, self._wanted(setting))
        except (LinAlgError, ValueError) as error:
            raise ArgumentError(f"{none}: {error}.") from None
        if not all(np.all(np.isfinite(found)) for found in (hold, correct, rest, feed)):
            raise ArgumentError(f"{none}: its gains are beyond all numbers.")
        return Design(a, b, c, hold, correct, feed + hold @ rest)

    def _wanted(self, setting: Setting) -> Array:
        """(ports,) weight of being where it should be at rest: next to none for a port without weight and reference."""
        weight = setting.by_port(self.error_weight)
        asked = np.any(setting.reference != 0, axis=0) | (weight > 0)
        given = np.where(weight > 0, weight / max(weight.max(), 1e-300), 1.0)
        return np.where(asked, given, UNASKED)

    def sampled_loop(self, setting: Setting) -> SampledLoop:
        """The loop around all modes: x, with lags and commands under way, and e = x - x_hat of what the model has of it.

        With x' for the corrected estimate, u = -hold x' and x' = x_hat + correct (y - C x_hat); x_hat+ = A x' + B u of the model,
        which knows nothing of lags.
        """
        a, b, c = sampled_model(setting.model(), setting, setting.lags)
        d = self.design(setting)
        predict = d.a - d.b @ d.hold
        corrected = np.eye(len(d.a)) - d.correct @ d.c
        feed = -d.hold @ d.correct @ c
        loop = np.block([[a + b @ feed, -b @ d.hold @ corrected], [predict @ d.correct @ c, predict @ corrected]])
        count, known = setting.model().count, min(self.modes, setting.model().count)
        lags = sum(map(len, setting.lags))
        seen = np.concatenate([np.arange(known), count + np.arange(known), np.arange(2 * count + lags, len(a))])
        swap = np.eye(len(loop))  # (x, x_hat) to (x, e), and back
        swap[len(a) + np.arange(len(d.a)), seen] = 1
        swap[len(a) :, len(a) :] *= -1
        return SampledLoop(swap @ loop @ swap, known, lags)

    def notes(self, setting: Setting) -> list[str]:
        """A warning where the modes that the design leaves out, or the rest of the loop, would grow."""
        radius = float(np.abs(np.linalg.eigvals(self.sampled_loop(setting).matrix)).max())
        if radius <= 1 + 1e-9:
            return []
        return [
            f"The LQG loop around all {setting.model().count} modes grows by {np.log(radius) / setting.dt:.3g} 1/s (spillover): "
            f"the {min(self.modes, setting.model().count)} modes of its model are too few, or its weights too bold."
        ]

    def lowest(self, model: ModalModel) -> ModalModel:
        """The modes that the controller knows of."""
        return ModalModel(omega=model.omega[: self.modes], b=model.b[:, : self.modes], decay=model.decay[: self.modes])

    def _shaking(self, setting: Setting, size: int) -> Array:
        """Covariance of the state after a sample of unit random forces at the ports."""
        _, held = transition(self.lowest(setting.model()), setting.dt)
        push = np.zeros((size, len(setting.ports)))
        push[: len(held)] = held
        return push @ push.T


def at_rest(a: Array, b: Array, c: Array, weight: Array) -> tuple[Array, Array]:
    """State and command, per unit of reference, in which the model stays, as near to y = reference as it can be held.

    All that stays is spanned by the null space of [A - I, B]; of that the least squares of sqrt(weight) (y - reference).
    """
    from scipy.linalg import null_space

    n, _ = b.shape
    stays = null_space(np.hstack([a - np.eye(n), b]))
    root = np.sqrt(weight)[:, None]
    solution = stays @ np.linalg.lstsq(root * (c @ stays[:n]), np.diag(root[:, 0]), rcond=1e-12)[0]
    return solution[:n], solution[n:]
