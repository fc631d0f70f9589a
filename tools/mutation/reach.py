"""The reach of a file's tests: which of them come by which line, how long each takes, which branches none takes."""

import ast
import json
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

import coverage
import pytest


@dataclass(frozen=True, slots=True)
class Untaken:
    """A line, or a branch from one line to another, that no test carries out; `scope` is where it stands."""

    name: str
    scope: tuple[str, ...]


@dataclass(slots=True)
class Reach:
    """By line the numbers of the tests, by test its seconds; `missing` says what no test carries out.

    failure    the test that does not even pass on the file as it is; "": all do
    """

    lines: dict[int, list[int]] = field(default_factory=dict)
    seconds: list[float] = field(default_factory=list)
    missing: list[Untaken] = field(default_factory=list)
    failure: str = ""

    def tests(self, first: int, last: int) -> list[int]:
        """Those that come by any of these lines, the quickest first."""
        reached = {test for line in range(first, last + 1) for test in self.lines.get(line, ())}
        return sorted(reached, key=lambda test: (self.seconds[test], test))


def passes(session: pytest.Session, items: Sequence[pytest.Item]) -> bool:
    """Carry tests out until one fails; whether none did."""
    for item, following in zip(items, [*items[1:], None], strict=True):
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
        if session.testsfailed:
            return False
    return True


def reach(session: pytest.Session, path: Path) -> Reach:
    """Carry out all tests of the session, and see what they reach in the file."""
    measured = Reach()
    trace = coverage.Coverage(data_file=None, config_file=False, branch=True, include=[str(path)], messages=False)
    trace.set_option("run:disable_warnings", ["no-data-collected"])
    trace.exclude(r"^\s*\.\.\.$")
    trace.exclude("if TYPE_CHECKING:")
    trace.start()
    for number, item in enumerate(session.items):
        trace.switch_context(str(number))
        begun = time.thread_time()
        if not passes(session, [item]):
            measured.failure = item.nodeid
            break
        measured.seconds.append(time.thread_time() - begun)
    trace.stop()
    data = trace.get_data()
    contexts = data.contexts_by_lineno(str(path))
    measured.lines = {line: [int(name) for name in names if name] for line, names in contexts.items()}
    if not measured.failure and str(path) in data.measured_files():  # one without functions has done all at loading
        measured.missing = list(_missing(trace, path))
    return measured


def _missing(trace: coverage.Coverage, path: Path) -> Iterable[Untaken]:
    """Lines of functions, and branches from one line to another, that nothing has carried out."""
    with TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        trace.json_report(outfile=str(report))
        [measured] = json.loads(report.read_text(encoding="utf-8"))["files"].values()
    text = path.read_text(encoding="utf-8")
    scopes = dict(_scopes(ast.parse(text), ()))
    shown = [line.strip() for line in ["", *text.splitlines()]]
    yield from (Untaken(f"line: {shown[line]}", scopes[line]) for line in measured["missing_lines"] if line in scopes)
    for line, then in measured["missing_branches"]:
        if line in scopes:
            name = f"branch: {shown[line]} -> {shown[then] if then > 0 else 'the end'}"
            yield Untaken(name, scopes[line])


def _scopes(parent: ast.AST, scope: tuple[str, ...]) -> Iterable[tuple[int, tuple[str, ...]]]:
    """The lines of functions, each with the classes and functions it stands in; inner ones come last."""
    for node in ast.iter_child_nodes(parent):
        inner = (*scope, node.name) if isinstance(node, ast.FunctionDef | ast.ClassDef) else scope
        if isinstance(node, ast.FunctionDef):
            yield from ((line, inner) for line in range(node.body[0].lineno, (node.end_lineno or 0) + 1))
        yield from _scopes(node, inner)
