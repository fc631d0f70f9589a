"""The trial of a file: its tests pass on it as it is, and then one of them has to fail on each of its mutants (R-X24).

Each mutant is planted in memory, in a fork of the process. One within a function takes the place of that function's
code after everything is loaded, and the tests that come by are carried out, the quickest first, until one fails. One
outside of all functions is planted before anything of ours is loaded.
"""

import gc
import os
import time
from collections.abc import Callable, Sequence
from importlib.machinery import SourceFileLoader
from pathlib import Path
from tempfile import TemporaryDirectory
from types import CodeType, FunctionType

import pytest

from mutation import child
from mutation.findings import Findings
from mutation.mutant import Mutant, MutatedFile
from mutation.reach import Reach, passes, reach
from mutation.safety_core import CoreFile

_OPTIONS = ("--assert=plain", "--capture=sys", "-p", "_hypothesis_pytestplugin", "--hypothesis-profile=mutation")
_QUICK = ("-m", "not page and not site and not slow", "-p", "no:cacheprovider", "-p", "no:faulthandler")
_QUIET = ("-q", "-W", "ignore::pytest.PytestAssertRewriteWarning")  # what others have loaded may be loaded already
_PATIENCE = 20
"""Tests that take so many times as long as without the mutant never end."""

Choice = Callable[[Sequence[Mutant]], list[Mutant]]


def trial(root: Path, core_file: CoreFile, choice: Choice = list) -> Findings:
    """Try a file of the safety core with its tests; `choice` picks the mutants. Nothing of ours may be loaded yet."""
    begun = time.monotonic()
    path, file = core_file.path, root / core_file.path
    mutated_file = MutatedFile(file.read_text(encoding="utf-8"), str(file))
    mutants = choice([mutant for mutant in mutated_file.mutants if core_file.covers(mutant.place.scope)])
    tried = Findings(path, len(mutants))
    arguments = [*_OPTIONS, *_QUICK, *_QUIET, f"--rootdir={root}", *(str(root / test) for test in core_file.tests)]
    with TemporaryDirectory(prefix="mutants-") as folder:
        os.chdir(folder)  # what a mutant leaves behind is left there
        os.environ |= {"PYTEST_DEBUG_TEMPROOT": folder, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
        ended = pytest.main(arguments, plugins=[_Plan(core_file, file, mutated_file, mutants, tried)])
    if ended == pytest.ExitCode.INTERNAL_ERROR:
        tried.failure = "the trial itself has failed"
    tried.survivors.sort(key=[mutant.name for mutant in mutants].index)
    tried.seconds = time.monotonic() - begun
    return tried


class _Plan:
    """Takes the place of pytest's own loop over the tests."""

    def __init__(
        self, core_file: CoreFile, file: Path, mutated_file: MutatedFile, mutants: Sequence[Mutant], tried: Findings
    ) -> None:
        self._core_file = core_file
        self._file = file
        self._mutated_file = mutated_file
        self._local = [mutant for mutant in mutants if mutated_file.is_local(mutant)]
        self._others = [mutant for mutant in mutants if not mutated_file.is_local(mutant)]
        self._tried = tried
        self._reach = Reach()

    @pytest.hookimpl(tryfirst=True)
    def pytest_collection(self, session: pytest.Session) -> None:
        """Before anything of ours is loaded."""
        if self._others and not self._passes_loaded(session, self._mutated_file.original):
            self._tried.failure = "the tests do not pass on the file as it is"
            return
        for mutant in self._others:
            if self._passes_loaded(session, self._mutated_file.code(mutant)):
                self._tried.survivors.append(mutant.name)

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """After everything is loaded."""
        measured = child.answer(lambda: reach(session, self._file), 600.0, 600)
        if measured is None or measured.failure or not session.items:
            self._tried.failure = "the tests end the process" if measured is None else measured.failure or "no test"
            return True
        self._reach = measured
        self._tried.missing = [line.name for line in measured.missing if self._core_file.covers(line.scope)]
        gc.unfreeze()  # the tests freeze what they have loaded, and what is frozen is not found
        functions = _functions(str(self._file))
        gc.freeze()  # forks share what is there
        if not child.passes(lambda: passes(session, session.items), 600.0, 600):
            self._tried.failure = "the tests do not pass on the file as it is when they are carried out again"
            return True
        for mutant in self._local:
            if self._passes_exchanged(session, mutant, functions[mutant.place.function]):
                self._tried.survivors.append(mutant.name)
        return True

    def _passes_loaded(self, session: pytest.Session, code: CodeType) -> bool:
        """Whether all tests pass where this code is loaded in place of the file's."""
        get_code = SourceFileLoader.get_code

        def get_planted(loader: SourceFileLoader, name: str) -> CodeType | None:
            return code if loader.path == str(self._file) else get_code(loader, name)

        def carried_out() -> bool:
            SourceFileLoader.get_code = get_planted  # type: ignore[method-assign]
            session.perform_collect()
            return passes(session, session.items)

        return child.passes(carried_out, 600.0, 60)

    def _passes_exchanged(self, session: pytest.Session, mutant: Mutant, functions: list[FunctionType]) -> bool:
        """Whether all tests that come by pass where the code of a function is exchanged."""
        code = self._mutated_file.function_code(mutant)
        numbers = self._reach.tests(*mutant.place.lines)
        items = [session.items[number] for number in numbers]
        limit_s = 2 + _PATIENCE * sum(self._reach.seconds[number] for number in numbers)

        def carried_out() -> bool:
            for function in functions:
                function.__code__ = code
            return passes(session, items)

        return child.passes(carried_out, 30 + 10 * limit_s, int(limit_s) + 1)


def _functions(path: str) -> dict[tuple[str, int] | None, list[FunctionType]]:
    """The functions of a file that are loaded, by name and first line."""
    functions: dict[tuple[str, int] | None, list[FunctionType]] = {}
    for function in gc.get_objects():
        if isinstance(function, FunctionType) and function.__code__.co_filename == path:
            code = function.__code__
            functions.setdefault((code.co_qualname, code.co_firstlineno), []).append(function)
    return functions
