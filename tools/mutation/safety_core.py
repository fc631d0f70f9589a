"""The safety core: the files that see to it that a failure ends in a hold, each with the tests that prove it (R-X24).

It stands in pyproject.toml under [tool.onika.safety-core]; of a file that does much else, the functions that are meant
stand under [tool.onika.safety-core-functions]. What no test can notice stands beside this file, in
survivors.toml: by file, the name of the mutant or of the branch, and the reason why it is no mistake.
"""

import tomllib
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from mutation.findings import Findings

Reasons = Mapping[str, Mapping[str, str]]

_SURVIVORS = Path(__file__).with_name("survivors.toml")


@dataclass(frozen=True, slots=True)
class CoreFile:
    """A file of the core, its tests, and the functions that are meant; none are named: all of the file."""

    path: str
    tests: Sequence[str]
    functions: Sequence[str] = ()

    def covers(self, scope: Sequence[str]) -> bool:
        """Whether what stands there, in classes and functions by name, is meant."""
        inside = f"{'.'.join(scope)}."
        return not self.functions or any(inside.startswith(f"{function}.") for function in self.functions)


def files(root: Path) -> dict[str, CoreFile]:
    """The files of the core by their path from the root."""
    onika = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["onika"]
    functions = onika["safety-core-functions"]
    return {path: CoreFile(path, tests, functions.get(path, ())) for path, tests in onika["safety-core"].items()}


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
