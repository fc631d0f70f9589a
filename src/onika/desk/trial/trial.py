"""Runs kept tests again: from test files to verdicts, several at a time (requirement X07)."""

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from time import monotonic

from onika.desk.run.settings import RunSettings
from onika.desk.trial.account import give_account
from onika.desk.trial.home import home_of
from onika.desk.trial.judging import Verdict, judge
from onika.files import kept, text
from onika.model.kept import KeptRun
from onika.model.redirect import Redirect
from onika.store.site import Site
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Trial:
    """A test that was done: its file, what came out, the seconds it took on the wall; its seed where it was shaken."""

    file: str
    verdict: Verdict
    wall_s: float
    shake: int | None = None

    @property
    def name(self) -> Reason:
        """What it is called in summaries."""
        if self.shake is None:
            return Reason.plain(self.file)
        return Reason.of("trial.shaken", file=self.file, seed=self.shake)


def find(paths: Sequence[Path], word: str = "") -> tuple[list[Path], list[Fault]]:
    """The test files at and below paths whose names hold a word; a fault for each path with none."""
    matches: list[Path] = []
    faults = []
    for path in paths:
        below = sorted(path.rglob(f"*{kept.ENDING}")) if path.is_dir() else [path] if path.is_file() else []
        if not below:
            faults.append(
                Fault(Place(str(path)), Reason.of("desk.no_test_file", ending=kept.ENDING), Reason.of("words.left_out"))
            )
        matches += [path for path in below if path not in matches and word.lower() in path.stem.lower()]
    return matches, faults


def read(path: Path) -> tuple[KeptRun | None, tuple[Fault, ...]]:
    """The kept run of a test file."""
    source, faults = text.load(path, str(path))
    if source is not None:
        return kept.read(source, path.stem, str(path))
    return (None, faults)


def settings_of(kept_run: KeptRun, shake: int | None = None) -> RunSettings:
    """The run that a test asks for; shaken: with another seed, and the things of its worlds a little elsewhere."""
    return RunSettings(
        name=kept_run.application,
        is_virtual=True,
        has_black_box=False,
        expectations=tuple(map(Condition.parse, kept_run.expectations)),
        settle_s=kept_run.settle_s,
        seed=kept_run.seed + (shake or 0),
        answers=kept_run.answers,
        redirects=tuple(map(Redirect.parse, kept_run.redirects)),
        shake=shake,
    )


def limit_of(kept_run: KeptRun) -> float:
    """How much time a run may take at most: twice as much as all that was kept of it, and a minute."""
    return 60.0 + 2.0 * sum(action.lasts_s for flow in kept_run.flows for action in flow.actions)


def try_out(path: Path, site: Site, shake: int | None = None) -> Trial:
    """Do one test."""
    began = monotonic()
    kept_run, faults = read(path)
    if kept_run is None:
        verdict = Verdict(tuple(fault.sentence for fault in faults))
    else:
        verdict = judge(kept_run, give_account(settings_of(kept_run, shake), home_of(path, site), limit_of(kept_run)))
    return Trial(str(path), verdict, monotonic() - began, shake)


def try_all(paths: Iterable[Path], site: Site, *, workers: int = 1, shakes: int = 0) -> Iterator[Trial]:
    """Do tests, so many at a time, and tell their outcome in order; each also with this many shaken worlds."""
    wanted = [(path, shake) for path in paths for shake in (None, *range(1, shakes + 1))]
    with ThreadPoolExecutor(max(workers, 1)) as pool:
        futures = [pool.submit(try_out, path, site, shake) for path, shake in wanted]
        try:
            for future in futures:
                yield future.result()
        finally:
            for future in futures:
                future.cancel()
