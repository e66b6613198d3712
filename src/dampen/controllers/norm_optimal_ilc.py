"""Norm-optimal iterative learning."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar

import numpy as np
from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.component import wrong
from dampen.controllers.base import Array, Assumption, Controller, Memory, PortLaw, Setting, Trial, named
from dampen.controllers.scales import feedback, scales, span

TOLERANCE, ITERATIONS = 1e-13, 5000
FEW = 150  # iterations in each trial, beyond which factors of the matrix, once for all trials, cost less
LARGEST = 6000  # unknowns whose matrix is still factorised: 0.3 GB


@dataclass(frozen=True)
class NormOptimalILC(Controller):
    """Norm-optimal iterative learning control, beside an optional PD feedback.

        u_(j+1) minimises  error_weight |e_(j+1)|^2 + effort_weight |u|^2 + change_weight |u - u_j|^2

    over all commands of a trial, where e_(j+1) = e_j + P (u - u_j) and P is the lifted response of the structure with its
    feedback, computed from the model. The norms are means over the trial of squares, errors weighted by port. Without
    effort weight, a repeated disturbance and equal starts, the error's norm falls from trial to trial. Source: Amann, Owens
    and Rogers, IEE Proc. Control Theory Appl. 143, 1996.
    """

    kind: ClassVar[str] = "norm-optimal-ilc"

    error_weight: Annotated[dict[str, float], Ge(0), Unit("1/m^2, 1/rad^2"), Doc("by port, weight of the error; left out: 1")] = (
        field(default_factory=dict)
    )
    effort_weight: Annotated[float, Ge(0), Unit("1/N^2, 1/(N m)^2"), Doc("weight of the command")] = 0.0
    change_weight: Annotated[float, Ge(0), Unit("1/N^2, 1/(N m)^2"), Doc("weight of the command's change between trials")] = 1e-4
    damping: Annotated[dict[str, float], Ge(0), Unit("N s/m, N m s"), Doc("by port, damping of the feedback")] = field(
        default_factory=dict
    )
    stiffness: Annotated[dict[str, float], Ge(0), Unit("N/m, N m/rad"), Doc("by port, stiffness of the feedback")] = field(
        default_factory=dict
    )

    def check(self) -> None:
        if self.effort_weight + self.change_weight == 0:
            raise wrong("change_weight", "be > 0 where `effort_weight` is 0", self.change_weight)

    def ports_named(self) -> Mapping[str, str]:
        return named(error_weight=self.error_weight, damping=self.damping, stiffness=self.stiffness)

    @property
    def relies_on(self) -> tuple[Assumption, ...]:
        return ("equal starts", "repetition")

    def design_time(self, trials: int, steps: int, ports: int) -> float:
        """Of the factors, once, or of conjugate gradients in each trial, as measured."""
        unknowns = steps * ports
        return 5e-11 * unknowns**3 if unknowns <= LARGEST else 2e-4 * trials * unknowns

    def search(self, setting: Setting) -> Mapping[str, str]:
        """The weight of a change, in units of what the error weighs that a unit of command makes at rest; weights of the errors
        of all ports but the first, in units of that one's own; and the feedback of every port with an actuator. Every port's
        error teaches every command."""
        acting = scales(setting)
        if not acting:
            return {}
        soft, first = max(1 / s.stiffness for s in acting), self.error_weight.get(setting.ports[0].name, 1.0) or 1.0
        found = {"change_weight": span(first * soft**2, 1e-6, 10)}
        found |= {f"error_weight.{port.name}": span(first, 0.01, 100) for port in setting.ports[1:]}
        return {**found, **feedback(acting)}

    def begin(self, setting: Setting) -> Memory:
        return {"learned": np.zeros((setting.steps, len(setting.ports)))}

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return PortLaw(memory["learned"], damping=setting.by_port(self.damping), stiffness=setting.by_port(self.stiffness))

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        """The solution of (P' Q P + (r + s) I) (u - u_j) = -P' Q e_j - r u_j."""
        if "lifted" not in setting.kept:
            setting.kept["lifted"] = Lifted(setting.response())
        lifted = setting.kept["lifted"]
        weight, command = setting.by_port(self.error_weight, 1.0), memory["learned"]
        ridge = self.effort_weight + self.change_weight
        right = -lifted.back(weight * trial.error[1:]) - self.effort_weight * command
        return {"learned": command + lifted.solve(weight, ridge, right)}


class Lifted:
    """The lifted matrix P, block Toeplitz, through fast Fourier transforms. response: (steps, ports out, ports in)."""

    def __init__(self, response: Array):
        self.steps, self.response = len(response), response
        self.acting = np.flatnonzero(np.any(response != 0, axis=(0, 1)))  # ports whose commands do anything
        self.factors: Any = None
        self.spectrum = np.fft.rfft(response, 2 * self.steps, axis=0)

    def __call__(self, u: Array) -> Array:
        """P u, (steps, ports)."""
        product = np.einsum("fpr,fr->fp", self.spectrum, np.fft.rfft(u, 2 * self.steps, axis=0))
        return np.asarray(np.fft.irfft(product, 2 * self.steps, axis=0)[: self.steps])

    def back(self, e: Array) -> Array:
        """P' e, (steps, ports)."""
        product = np.einsum("fpr,fp->fr", self.spectrum.conj(), np.fft.rfft(e, 2 * self.steps, axis=0))
        return np.asarray(np.fft.irfft(product, 2 * self.steps, axis=0)[: self.steps])

    def solve(self, weight: Array, ridge: float, right: Array) -> Array:
        """The solution u, (steps, ports), of (P' Q P + ridge I) u = right, for the weights Q and the ridge of the first call.

        By conjugate gradients; where they are slow, since the ridge is small, by Cholesky factors, which serve further calls.
        """
        from scipy.linalg import cho_factor, cho_solve

        direct = self.steps * len(self.acting) <= LARGEST
        if self.factors is None:
            limit = FEW if direct else ITERATIONS
            u, done = conjugate_gradients(lambda u: self.back(weight * self(u)) + ridge * u, right, limit)
            if done or not direct:
                return u
            self.factors = cho_factor(self.normal(weight, ridge), lower=True, overwrite_a=True, check_finite=False)
        u = right / ridge  # where a command does nothing
        turned = right[::-1, self.acting].ravel()
        u[::-1, self.acting] = cho_solve(self.factors, turned, check_finite=False).reshape(self.steps, -1)
        return u

    def normal(self, weight: Array, ridge: float) -> Array:
        """P' Q P + ridge I of the commands that do anything, (steps ports, steps ports), steps in reverse order.

        From the end, row by row: what two commands have in common grows by one step of the response as both come one earlier,
        G(a, b) = G(a - 1, b - 1) + h(a)' Q h(b).
        """
        response = self.response[:, :, self.acting] * np.sqrt(weight)[:, None]
        count = len(self.acting)
        h = response.transpose(0, 2, 1).reshape(self.steps * count, -1)
        g = h @ h.T
        for a in range(count, len(g), count):
            g[a : a + count, count:] += g[a - count : a, :-count]
        g[np.diag_indices_from(g)] += ridge
        return np.asarray(g)


def conjugate_gradients(matrix: Callable[[Array], Array], right: Array, limit: int = ITERATIONS) -> tuple[Array, bool]:
    """The solution of a symmetric positive definite system, given as a product, and whether it was reached within the limit."""
    x, r = np.zeros_like(right), right.copy()
    p, square = r.copy(), float(np.sum(r * r))
    target = TOLERANCE**2 * square
    for _ in range(limit):
        if square <= target:
            return x, True
        product = matrix(p)
        step = square / float(np.sum(p * product))
        x += step * p
        r -= step * product
        square, before = float(np.sum(r * r)), square
        p = r + square / before * p
    return x, square <= target
