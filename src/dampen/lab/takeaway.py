"""What can be taken away from the lab: the scenario, its result, its figures, its report."""

from __future__ import annotations

import zipfile
from collections.abc import Callable, Iterable
from pathlib import Path

from dampen.lab.tables import Trust
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.simulation.stores import FileArrays, FileStore
from dampen.simulation.trials import simulate
from dampen.toml import to_toml


def take(what: str, scenario: Scenario, trust: Trust, folder: Path) -> tuple[Path, str]:
    """Make one of TAKEAWAYS in an empty folder: the file, and the name to save it under."""
    return TAKEAWAYS[what](scenario, trust, folder)


def toml(scenario: Scenario, trust: Trust, folder: Path) -> tuple[Path, str]:
    """The scenario file; with the attachments that it names, in an archive."""
    text = portable(to_toml(scenario), trust)
    path = folder / "scenario.toml"
    path.write_text(text, encoding="utf-8")
    return with_files(path, text, trust, f"{scenario.name}.toml")


def netcdf(scenario: Scenario, trust: Trust, folder: Path) -> tuple[Path, str]:
    """The result, as `dampen run` writes it; with the attachments that its scenario names, in an archive."""
    import netCDF4

    path = folder / "result.nc"
    written = simulate(scenario, store=FileStore(path)).arrays
    assert isinstance(written, FileArrays)
    written.file.close()
    with netCDF4.Dataset(path, "a") as file:
        text = portable(file.getncattr("scenario"), trust)
        file.setncattr("scenario", text)
    return with_files(path, text, trust, f"{scenario.name}.nc")


def figures(scenario: Scenario, trust: Trust, folder: Path) -> tuple[Path, str]:
    """Every figure of the report, PNG and SVG."""
    report(scenario, trust, folder)
    return packed(folder / "figures.zip", sorted((folder / "figures").iterdir())), f"{scenario.name}-figures.zip"


def report(scenario: Scenario, trust: Trust, folder: Path) -> tuple[Path, str]:
    """The report of `dampen run`: the run with and without control, its claims, its audit."""
    from dampen.report.write import report_of
    from dampen.studies.experiment import own_review, run_all

    bench = Bench(scenario)
    runs = run_all(bench, folder)
    return report_of(runs, folder, own_review(bench, runs.result)), f"{scenario.name}.html"


TAKEAWAYS: dict[str, Callable[[Scenario, Trust, Path], tuple[Path, str]]] = {
    "toml": toml,
    "netcdf": netcdf,
    "figures": figures,
    "report": report,
}


def portable(text: str, trust: Trust) -> str:
    """A scenario's text with its attachments named as if they lay beside it."""
    return text.replace(f"{trust.attachments.resolve()}/", "").replace(f"{trust.attachments}/", "")


def with_files(path: Path, text: str, trust: Trust, name: str) -> tuple[Path, str]:
    """A file under its own name, or, where the scenario's text names attachments, an archive of it and of them."""
    beside = [file for file in trust.attachments.iterdir() if file.name in text]
    if not beside:
        return path, name
    return packed(path.with_suffix(".zip"), [path, *beside]), f"{Path(name).stem}.zip"


def packed(archive: Path, files: Iterable[Path]) -> Path:
    """Files in an archive."""
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as writer:
        for file in files:
            writer.write(file, file.name)
    return archive
