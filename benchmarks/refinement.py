"""What depends on the time step, for every shipped scenario; writes docs/validation/refinement.md.

python benchmarks/refinement.py            all scenarios, some minutes
python benchmarks/refinement.py NAME ...   some of them, printed only
"""

from __future__ import annotations

import sys
from pathlib import Path

import dampen
from dampen.analysis.refinement import refine
from dampen.scenarios.read import shipped

HEAD = """# What depends on the time step

Every shipped scenario at its own step, at half and at a quarter of it; made by `python benchmarks/refinement.py`. Modes, sample
periods and delays stay as they are. The last two columns say how far the shipped and the halved step are from the quarter.

Smooth laws (LQG, PD with the tan barrier, norm-optimal learning) converge at second order and move by little. Where a
set-valued Sgn holds a port, the force that holds it and what is left in late trials depend on the step: a stuck port has a
numerical compliance, proportional to the step, that takes energy from what is trapped behind it. Peaks and constraint margins,
which belong to the first trials, do not move. In sampled scenarios the controller's own period decides about chatter, and the
step only about how exactly the structure moves between samples.
"""


def table(name: str) -> str:
    scenario = dampen.read_scenario(name)
    step = 1000 * scenario.numerics.step
    lines = [
        f"\n## {name}\n",
        f"| | {step:g} ms | {step / 2:g} ms | {step / 4:g} ms | {step:g} ms off by | {step / 2:g} ms off by |",
    ]
    lines.append("|---|---|---|---|---|---|")
    for row in refine(scenario):
        values = " | ".join(f"{value:.4g}" for value in row.values)
        changes = " | ".join(f"{change:.2%}" for change in row.changes)
        lines.append(f"| {row.name} [{row.unit}] | {values} | {changes} |")
    return "\n".join(lines)


def main() -> None:
    names = sys.argv[1:]
    if names:
        print("\n".join(map(table, names)))
        return
    pages = [HEAD]
    for name in shipped():
        print(name, file=sys.stderr)
        pages.append(table(name))
    (Path(__file__).parents[1] / "docs" / "validation" / "refinement.md").write_text("\n".join(pages) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
