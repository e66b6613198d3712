"""Figures of merit of a run, trial by trial, so that a result of any length can be read from its file."""

from __future__ import annotations

import numpy as np

from dampen.simulation.result import Result

Array = np.ndarray


def peaks(result: Result, field: str) -> Array:
    """(trials,) largest |field|: over snapshots everywhere, over the ports at every step."""
    index = list(result.layout.coordinates["field"][1]).index(field)
    return np.asarray(result["peak"][: result.trials])[:, index]


def field_rms(result: Result, field: str, trial: int) -> float:
    """Root mean square of a field over the structure and the trial."""
    return float(np.sqrt(np.mean(np.square(np.asarray(result[field][trial], float)))))


def port_index(result: Result, port: str) -> int:
    """Place of a port among the result's ports."""
    return list(result.layout.coordinates["port"][1]).index(port)


def largest(result: Result, name: str, port: str | None = None) -> Array:
    """(trials,) largest absolute value of a variable in each trial, at one port or over all."""
    column = (Ellipsis,) if port is None else (Ellipsis, port_index(result, port))
    return np.array([np.max(np.abs(np.asarray(result[name][j])[column])) for j in range(result.trials)])


def port_rms(result: Result, port: str, trial: int) -> float:
    """Root mean square of a port's displacement over a trial."""
    return float(np.sqrt(np.mean(np.square(np.asarray(result["y"][trial])[:, port_index(result, port)]))))


def tracking_error(result: Result, port: str, trial: int) -> Array:
    """(times,) displacement of a port less what it was to follow, which is zero where there is no reference."""
    p = port_index(result, port)
    y = np.asarray(result["y"][trial])[:, p]
    return y - np.asarray(result["reference"][trial])[:, p] if "reference" in result.layout.variables else y


def error_rms(result: Result, port: str) -> Array:
    """(trials,) root mean square of a port's tracking error over each trial."""
    return np.array([np.sqrt(np.mean(np.square(tracking_error(result, port, j)))) for j in range(result.trials)])


def error_peaks(result: Result, port: str) -> Array:
    """(trials,) largest modulus of a port's tracking error in each trial."""
    return np.array([np.max(np.abs(tracking_error(result, port, j))) for j in range(result.trials)])


def fraction_of_limit(result: Result, port: str) -> Array:
    """(trials,) largest share of its constraint that a port used in each trial: 1 is the limit; 0 where there is none.

    Limits that lie unevenly about the reference, or move, are taken as they are at each time.
    """
    p, shares = port_index(result, port), []
    for j in range(result.trials):
        reference = result.scenario.reference(j)[:, p]
        low, high = (limit[:, p] - reference for limit in result.scenario.limits(j))
        error = np.asarray(result["y"][j])[:, p] - reference
        shares.append(float(np.max(np.where(error >= 0, error / high, error / low))))
    return np.array(shares)


def first_beyond(result: Result, port: str) -> tuple[int, float] | None:
    """The trial, and the time [s] in it, at which a port is first at its constraint or beyond; None: it never is."""
    p = port_index(result, port)
    for j in range(result.trials):
        y, (low, high) = np.asarray(result["y"][j])[:, p], result.scenario.limits(j)
        beyond = np.flatnonzero(~((low[:, p] < y) & (y < high[:, p])))
        if len(beyond):
            return j, float(result.time[beyond[0]])
    return None


def settling_trial(errors: Array, bounds: Array) -> int | None:
    """The first trial from which on every port's largest |error| stays within its bound; None: not even the last one is.

    errors: (trials, ports) largest |error| of each trial.   bounds: (ports,); infinite for a port that does not count.
    """
    outside = np.flatnonzero(~(errors <= bounds).all(axis=1))
    settled = int(outside[-1]) + 1 if len(outside) else 0
    return settled if settled < len(errors) else None
