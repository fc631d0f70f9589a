"""The safety core: the files that see to it that a failure ends in a hold, each with the tests that prove it (R-X24).

It stands in pyproject.toml under [tool.onika.safety-core]. What no test can notice stands beside this file, in
survivors.toml: by file, the name of the mutant or of the branch, and the reason why it is no mistake.
"""

import tomllib
from collections.abc import Collection, Iterable, Iterator, Mapping
from pathlib import Path

from mutation.findings import Findings

Reasons = Mapping[str, Mapping[str, str]]

_SURVIVORS = Path(__file__).with_name("survivors.toml")


def files(root: Path) -> dict[str, list[str]]:
    """The files of the core, each with its tests, as paths from the root."""
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))
    core: dict[str, list[str]] = project["tool"]["onika"]["safety-core"]
    return core


def reasons(path: Path = _SURVIVORS) -> Reasons:
    """Why some mutants and branches may stay, by file and name."""
    named: dict[str, dict[str, str]] = tomllib.loads(path.read_text(encoding="utf-8"))
    return named


def complaints(trials: Iterable[Findings], named: Reasons, core: Collection[str], *, is_whole: bool) -> Iterator[str]:
    """What is wrong: survivors without a reason, and reasons without a survivor, where all mutants were tried."""
    for tried in trials:
        if tried.failure:
            yield f"{tried.path}: {tried.failure}"
            continue
        remaining = [*tried.survivors, *tried.missing]
        explained = named.get(tried.path, {})
        yield from (f"{tried.path}: survives: {name}" for name in tried.survivors if name not in explained)
        yield from (f"{tried.path}: never carried out: {name}" for name in tried.missing if name not in explained)
        if is_whole:
            yield from (
                f"{tried.path}: strike it, it is no more: {name}" for name in explained if name not in remaining
            )
    yield from (f"survivors.toml: {path} is not of the safety core" for path in named if path not in core)
