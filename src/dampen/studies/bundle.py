"""A run's folder as one archive that can be cited and run again: all files, those that its scenario names, what made them."""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
import os
import platform
import re
import sys
import zipfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import scipy.linalg  # noqa: F401  (loaded first, so that the limit reaches its BLAS too)
from threadpoolctl import threadpool_limits

from dampen.archive import archive as zipped
from dampen.archive import whole_file
from dampen.component import ArgumentError
from dampen.release import version
from dampen.scenarios.read import read_scenario
from dampen.scenarios.results import load
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.trials import simulate

SCHEMA = "dampen-bundle/1"
MANIFEST, SCENARIO, RESULT = "manifest.json", "scenario.toml", "result.nc"
OWN = re.compile(r'"([A-Za-z_][\w.]*):[A-Za-z_][\w.]*"')  # "module:name" in a scenario
README = """# {title}

Run `{name}` of dampen {version}, as it lay in its folder, with the files that its scenario names.

    pip install dampen=={version}       # requirements.txt has every package as it was
    dampen run scenario.toml            # in the unpacked folder
    dampen rerun {archive}              # or from the archive: checks its files, runs it again, compares

`manifest.json` has the SHA-256 of every file, and Python, processor and packages of the machine that made this archive.

To cite the software: dampen, version {version}. To cite the run: this archive, by its own SHA-256 or by where it is deposited.
"""


@dataclass(frozen=True)
class Rerun:
    """A run from an archive, made again.

    differences: of each signal, the largest, as a share of its largest value.   then, now: version, Python and processor.
    """

    scenario: Scenario
    status: str
    differences: Mapping[str, float]
    then: Mapping[str, Any]
    now: Mapping[str, Any]

    @property
    def largest(self) -> float:
        return max(self.differences.values(), default=0.0)


def pack(folder: Path, archive: Path) -> Path:
    """Write the archive of a run's or a study's folder; returns its path.

    Raises ArgumentError for a folder without a scenario, and where the archive cannot be written.
    """
    text = scenario_text(Path(folder))
    folder, archive = Path(folder).absolute(), Path(archive)
    scenario = read_scenario(folder / SCENARIO)
    content = {path.relative_to(folder).as_posix(): path.read_bytes() for path in files_in(folder) if path != archive.absolute()}
    named, text = named_files(folder, text)
    content |= {name: path.read_bytes() for name, path in named.items()}
    content[SCENARIO] = text.encode()
    made = made_with()
    content["requirements.txt"] = "".join(f"{name}=={number}\n" for name, number in made["packages"].items()).encode()
    words = {"title": scenario.title or scenario.name, "name": scenario.name, "version": version(), "archive": archive.name}
    content["README.md"] = README.format(**words).encode()
    digests = {name: hashlib.sha256(data).hexdigest() for name, data in sorted(content.items())}
    content[MANIFEST] = (json.dumps({"schema": SCHEMA, **made, "files": digests}, indent=1) + "\n").encode()
    with whole_file(archive, "Archive") as out:
        out.write(zipped({f"{archive.stem}/{name}": content[name] for name in sorted(content)}))
    return archive


def scenario_text(folder: Path) -> str:
    """The scenario of a run's folder."""
    try:
        return (folder / SCENARIO).read_text(encoding="utf-8")
    except OSError as error:
        why = "it has no scenario.toml" if folder.is_dir() else error.strerror
        raise ArgumentError(f"Folder `{folder}` is none of a run or a study: {why}.") from None


def files_in(folder: Path) -> list[Path]:
    """All files of a folder, but for hidden ones and what Python has compiled."""
    found = (path for path in sorted(folder.rglob("*")) if path.is_file())
    parts = ((path, path.relative_to(folder).parts) for path in found)
    return [path for path, names in parts if not any(name.startswith(".") or name == "__pycache__" for name in names)]


def named_files(folder: Path, text: str) -> tuple[dict[str, Path], str]:
    """The files that a scenario's text names, records and modules of one's own, by their place in the archive; and the text with
    records named there."""
    found: dict[str, Path] = {}
    for path in {Path(p) for p in re.findall(r'"([^"\n]+)"', text) if os.sep in p}:
        if path.is_absolute() and path.is_file():
            place = f"files/{hashlib.sha256(str(path.parent).encode()).hexdigest()[:8]}/{path.name}"
            found[place] = path
            text = text.replace(f'"{path}"', f'"{place}"')
    for module in {name.partition(".")[0] for name in OWN.findall(text)}:
        found |= sources_of(module, folder)
    return found, text


def sources_of(module: str, folder: Path) -> dict[str, Path]:
    """The source files of a module of one's own; nothing for one that is installed."""
    places = [str(folder), str(Path().absolute())]
    sys.path[:0] = places
    try:
        spec = find_spec(module)
    finally:
        for place in places:
            sys.path.remove(place)
    if spec is None or spec.origin is None or "site-packages" in Path(spec.origin).parts:
        return {}
    origin = Path(spec.origin)
    if spec.submodule_search_locations:
        return {str(PurePosixPath(module, *p.relative_to(origin.parent).parts)): p for p in sorted(origin.parent.rglob("*.py"))}
    return {origin.name: origin}


def made_with() -> dict[str, Any]:
    """Version, Python, system, processor, and the packages that dampen needs, as they are here."""
    packages = {"dampen": version()}
    queue = ["dampen"]
    while queue:
        for line in importlib.metadata.requires(queue.pop()) or []:
            name = re.split(r"[^\w.-]", line, maxsplit=1)[0]
            if (";" in line and "extra" in line.partition(";")[2]) or name in packages:
                continue
            try:
                packages[name] = importlib.metadata.version(name)
            except importlib.metadata.PackageNotFoundError:
                continue  # of another system
            queue.append(name)
    return {
        "version": version(),
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.release()}",
        "processor": platform.machine(),
        "packages": dict(sorted(packages.items(), key=lambda item: item[0].lower())),
    }


def rerun(archive: Path, progress: Callable[[int, int], None] | None = None) -> Rerun:
    """Check every file of an archive against its digest, run its scenario again, and compare.

    Raises ArgumentError for what is no such archive, is damaged, or holds no run.
    """
    with TemporaryDirectory() as place:
        folder, manifest = unpacked(Path(archive), Path(place))
        if not (folder / RESULT).is_file():
            raise ArgumentError(f"Archive `{archive}` holds no run that could be made again: it has no {RESULT}.")
        old = load(folder / RESULT)
        scenario = read_scenario(folder / SCENARIO)
        with threadpool_limits(1):  # as `dampen run` does
            new = simulate(scenario, progress=progress)
        found = differences(old, new)
    then = {key: manifest.get(key, "?") for key in ("version", "python", "processor")}
    return Rerun(scenario, new.status, found, then, {key: value for key, value in made_with().items() if key in then})


def unpacked(archive: Path, place: Path) -> tuple[Path, dict[str, Any]]:
    """An archive's files in a folder, checked; its manifest."""
    try:
        with zipfile.ZipFile(archive) as packed:
            packed.extractall(place)
    except (OSError, zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError) as error:
        why = getattr(error, "strerror", None) or str(error) or type(error).__name__
        raise ArgumentError(f"Archive `{archive}` cannot be read: {why}.") from None
    manifests = list(place.glob(f"*/{MANIFEST}"))
    try:
        manifest = json.loads(manifests[0].read_text(encoding="utf-8"))
        known = manifest["schema"] == SCHEMA and all(isinstance(v, str) for v in manifest["files"].values())
    except (LookupError, ValueError, TypeError, AttributeError, OSError):
        known = False
    if not known:
        raise ArgumentError(f"Archive `{archive}` is none that `dampen bundle` wrote: it has no {MANIFEST} of {SCHEMA}.")
    folder = manifests[0].parent
    for name, digest in manifest["files"].items():
        path = folder / name
        if not path.is_file() or hashlib.sha256(path.read_bytes()).hexdigest() != digest:
            raise ArgumentError(f"Archive `{archive}` is damaged: `{name}` is not what its manifest says.")
    return folder, manifest


def differences(old: Result, new: Result) -> dict[str, float]:
    """Of each variable that both have, the largest difference as a share of the largest value; of trials that both have."""
    found, trials = {}, min(old.trials, new.trials)
    for name in old.layout.variables:
        if name not in new.layout.variables or name in ("status", "unsettled"):
            continue
        a, b = (np.asarray(result[name][:trials], float) for result in (old, new))
        size = float(np.abs(a).max(initial=0.0))
        found[name] = float(np.abs(a - b).max(initial=0.0)) / (size or 1.0)
    return found
