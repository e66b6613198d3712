"""Which figures show a run that has no plan of its own: chosen by its task, its actuators and its mode."""

from __future__ import annotations

from collections.abc import Sequence

from dampen.actuators.absent import Absent
from dampen.actuators.ideal import Ideal
from dampen.report.joined import uncontrolled
from dampen.report.names import tracked
from dampen.scenarios.figures import FigurePlan, View
from dampen.simulation.result import Result

MOST = 12
COMMANDED: tuple[View, ...] = ("delivered", "loop", "samples")  # nothing to see in a run without control
CAPTIONS: dict[View, str] = {
    "field": "{}(x, t) over all trials",
    "port": "Motion at {}",
    "peaks": "Largest |{}| of each trial",
    "delivered": "What the actuator delivers at {}",
    "tracking": "{} and its reference",
    "error": "Error at {} from trial to trial",
    "loop": "The actuator's loop at {}",
    "samples": "What the controller sees and does at {}",
}


def default_plan(result: Result) -> tuple[FigurePlan, ...]:
    """The figures made for the task, the first of them in order of importance where they would be too many.

    suppression: every field, every port, peaks, delivered forces, and where there is room the fields without control;
    tracking: tracking and error at ports with a reference, the motion of the others, delivered forces, fields;
    both: loops at ports whose actuator is not ideal, and samples.
    """
    ports, fields = result.scenario.ports, [name for name, _ in result.scenario.plant.fields]
    driven = [name for name in ports if not absent(result, name)]
    following = [name for name in ports if tracked(result, name)]
    if following:
        free = [name for name in ports if name not in following]
        views: list[tuple[View, Sequence[str]]] = [("tracking", following), ("error", following), ("port", free)]
        views += [("delivered", driven), ("field", fields)]
    else:
        views = [("field", fields), ("port", ports), ("peaks", fields), ("delivered", driven)]
    views += [("loop", [name for name in driven if not ideal(result, name)]), ("samples", sampled_ports(result))]
    plan = [figure(view, name) for view, names in views for name in names]
    if not (following or uncontrolled(result)):  # where there is room, what a field would be without control, on the same scale
        plan = [*map(free_field, fields[: max(0, MOST - len(plan))]), *plan]
    if uncontrolled(result):
        plan = [one for one in plan if one.view not in COMMANDED]
    return tuple(plan[:MOST])


def free_field(name: str) -> FigurePlan:
    """A field without control."""
    return FigurePlan(f"free_{name}", "field", name, f"{name}(x, t) without control", controlled=False)


def figure(view: View, of: str) -> FigurePlan:
    """One figure with the caption of its view."""
    return FigurePlan(f"{view}_{of}", view, of, CAPTIONS[view].format(of))


def ideal(result: Result, port: str) -> bool:
    """Whether a port's actuator delivers what it is commanded."""
    return all(isinstance(stage, Ideal) for stage in result.scenario.actuators.get(port, ()))


def absent(result: Result, port: str) -> bool:
    """Whether there is no actuator at a port."""
    return any(isinstance(stage, Absent) for stage in result.scenario.actuators.get(port, ()))


def sampled_ports(result: Result) -> Sequence[str]:
    """The ports at which a controller acts through samples."""
    scenario = result.scenario
    return [name for name in scenario.ports if not absent(result, name)] if scenario.sampled and not uncontrolled(result) else ()


def completed(plan: Sequence[FigurePlan], result: Result) -> tuple[FigurePlan, ...]:
    """A scenario's own plan, and what it cannot know of: the samples of a sampled run, the loops where hysteresis is inverted."""
    inverted = [port for port in result.scenario.compensation if not uncontrolled(result)]
    more = [*(figure("loop", port) for port in inverted), *(figure("samples", port) for port in sampled_ports(result))]
    shown = {(one.view, one.of) for one in plan}
    return (*plan, *(one for one in more if (one.view, one.of) not in shown))
