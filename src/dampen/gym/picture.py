"""The structure as a picture, with its constraint."""

from __future__ import annotations

from typing import Any

import numpy as np

from dampen.gym.course import Course


def picture(course: Course, i: int = 0) -> Any:
    """(height, width, 3) bytes: the first field of run i along the structure, and the constraint of the ports that see it."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    stepper, told = course.stepper, course.one(i)
    bench, scale = stepper.bench, course.scaling
    figure = Figure(figsize=(4, 3), dpi=100)
    canvas, axes = FigureCanvasAgg(figure), figure.add_subplot()
    modal = stepper.fleet.modal[i]
    fields = bench.modes.fields
    if fields:
        axes.plot(bench.x, bench.shapes[fields[0].name] @ modal["q"][: bench.modes.count], lw=2)
    for p, port in enumerate(bench.site.ports):
        if not fields or port.field == fields[0].name:
            axes.plot(port.x, told["displacement"][p], "o")
            low, high = (limit[0, p] for limit in course.scenario.limits(int(told["trial"])))
            axes.vlines(port.x, *np.nan_to_num([low, high], neginf=-scale.error[p], posinf=scale.error[p]), color="0.7", zorder=0)
            axes.set_ylim(-1.2 * scale.error[p], 1.2 * scale.error[p])
    axes.set_title(f"trial {told['trial']}, t = {told['time']:.2f} s")
    canvas.draw()  # type: ignore[no-untyped-call]
    return np.asarray(canvas.buffer_rgba())[..., :3].copy()  # type: ignore[no-untyped-call]
