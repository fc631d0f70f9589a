"""Mutants of the safety core: planted one by one, each has to be noticed by a test (R-X24)."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from mutation import child, safety_core
from mutation.findings import Findings
from mutation.mutant import MutatedFile

ROOT = Path(__file__).resolve().parents[2]

BRAKE = '''"""A brake."""

LIMIT = 3
MODES = {"a": "held", "b": "driven"}


def holds(speed: float, is_pressed: bool = False) -> bool:
    """Whether it holds."""
    if speed > LIMIT and not is_pressed:
        return True
    return is_pressed


class Brake:
    """It counts."""

    __slots__ = ("count",)

    def __init__(self) -> None:
        self.count = 0

    @property
    def is_worn(self) -> bool:
        """Whether it is worn."""
        return self.count >= 2

    def press(self) -> None:
        """Once more."""
        self.count += 1
        if self.count > 9:
            self.count = 0
'''


def names(text):
    return [mutant.name for mutant in MutatedFile(text, "brake.py").mutants]


@pytest.mark.parametrize(
    "name",
    [
        "holds: speed > LIMIT -> speed >= LIMIT",
        "holds: speed > LIMIT -> speed <= LIMIT",
        "holds: speed > LIMIT and (not is_pressed) -> speed > LIMIT or not is_pressed",
        "holds: speed > LIMIT and (not is_pressed) -> not is_pressed",
        "holds: not is_pressed -> is_pressed",
        "holds: if speed > LIMIT and (not is_pressed): -> if False:",
        "holds: True -> False",
        "holds: return is_pressed -> return",
        "holds: False -> True",
        "module: 3 -> 4",
        "module: {'a': 'held', 'b': 'driven'} -> {'b': 'driven'}",
        "Brake.__init__: self.count = 0 -> pass",
        "Brake.is_worn: self.count >= 2 -> self.count > 2",
        "Brake.press: self.count += 1 -> self.count -= 1",
        "Brake.press: self.count += 1 -> self.count = 1",
    ],
)
def test_a_slip_of_the_pen_is_a_mutant(name):  # R-X24
    assert name in names(BRAKE)


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("try:\n    f()\nexcept (A, B):\n    g()", "except (A, B): g() -> except (A, B): raise"),
        ("try:\n    f()\nexcept (A, B):\n    g()", "except (A, B): g() -> except (A,): g()"),
        ("for x in y:\n    continue", "continue -> break"),
        ("a = [x for x in y if x]", "for x in y if x ->  for x in y"),
        ("match x:\n    case 1 if y:\n        f()\n    case 2:\n        g()", "match x: 1, 2 -> match x: 2"),
        ("f(x, y=z)", "f(x, y=z) -> f(x)"),
        ("a = min(b, c)", "min(b, c) -> max(b, c)"),
        ("a = x * 2.5", "2.5 -> 3.5"),
        ("raise x", "raise x -> pass"),
        ("a = lambda: b", "lambda: b -> lambda: None"),
        ("a = b'x' if c else d", "b'x' if c else d -> b'x' if False else d"),
        ("while a:\n    f()", "while a: -> while False:"),
        ("a = (b, c)", "(b, c) -> (c, c)"),
    ],
)
def test_every_kind_of_statement_has_its_slips(before, after):  # R-X24
    assert any(after in name for name in names(before)), names(before)


def test_what_is_no_behaviour_has_no_mutants():
    protocol = "class A(Protocol):\n    x: int = 1\n"
    assert names(f'"""Text."""\nfrom typing import Protocol\n{protocol}Said = Callable[[int], None]\n') == []
    assert not any("brake" in name or "__slots__" in name for name in names(BRAKE))


def test_every_mutant_has_a_name_of_its_own_and_differs_from_the_file():
    file = MutatedFile(BRAKE, "brake.py")
    assert len({mutant.name for mutant in file.mutants}) == len(file.mutants)
    for mutant in file.mutants:
        assert file.code(mutant) != file.original, mutant.name
        assert file.is_local(mutant) is (mutant.place.function is not None)
    fresh = MutatedFile(BRAKE, "brake.py")
    assert file.code(file.mutants[0]) == fresh.code(fresh.mutants[0])


def test_a_default_is_none_of_the_function_in_which_it_stands():
    places = {mutant.name: mutant.place.function for mutant in MutatedFile(BRAKE, "brake.py").mutants}
    assert places["holds: False -> True"] is None
    assert places["holds: True -> False"] == ("holds", 7)
    assert places["Brake.is_worn: 2 -> 3"] == ("Brake.is_worn", 22)


@pytest.mark.parametrize(
    ("work", "answer"),
    [
        (lambda: 7, 7),
        (lambda: 1 / 0, None),
        (lambda: os._exit(3), None),
        (lambda: os.kill(os.getpid(), signal.SIGKILL), None),
    ],
)
def test_a_child_that_breaks_harms_nobody(work, answer):
    assert child.answer(work, 60.0, 60) == answer


def test_a_child_that_never_ends_is_ended():
    def endless():
        while True:
            pass

    assert child.answer(endless, 600.0, 1) is None


def test_several_children_answer_as_they_end():
    works = [lambda number=number: number for number in range(5)]
    assert sorted(child.answers(works, 2, 60.0, 60)) == [0, 1, 2, 3, 4]


TESTS = """
from brake import LIMIT, MODES, Brake, holds

def test_it_holds_beyond_its_limit():
    assert [holds(speed) for speed in (3, 3.5)] == [False, True]

def test_it_is_worn_the_second_time():
    brake = Brake()
    assert brake.press() is None and not brake.is_worn
    brake.press()
    assert brake.is_worn
"""


PROFILE = """
from hypothesis import settings

settings.register_profile("mutation", settings.get_profile("ci"))
"""
"""The profile under which mutants are tried, as our own tests have it."""

FROZEN = """
import gc

def pytest_collection_finish():
    gc.freeze()
"""
"""What our own tests do once all is loaded."""


def trial_of_brake(root, functions=(), conftest=FROZEN):
    """What comes of the trial of the brake, or of some of its functions."""
    if "CI" not in os.environ:
        pytest.importorskip("coverage")
    (root / "brake.py").write_text(BRAKE)
    (root / "test_brake.py").write_text(TESTS)
    (root / "conftest.py").write_text(PROFILE + conftest)
    (root / "pyproject.toml").write_text("[tool.pytest.ini_options]\npythonpath = ['.']\n")
    program = (
        "import json, sys; from dataclasses import asdict; from pathlib import Path; from mutation.trial import trial\n"
        "from mutation.safety_core import CoreFile\n"
        f"core_file = CoreFile('brake.py', ['test_brake.py'], {functions!r})\n"
        "print(json.dumps(asdict(trial(Path.cwd(), core_file))), file=sys.stderr)"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT / "tools"), *sys.path])}
    command = [sys.executable, "-c", program]
    ended = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    return json.loads(ended.stderr.splitlines()[-1])


@pytest.fixture(scope="module")
def tried(tmp_path_factory):
    return trial_of_brake(tmp_path_factory.mktemp("brake"))


def test_a_mutant_that_no_test_notices_survives_and_no_other(tried):  # R-X24
    assert tried["failure"] == ""
    survivors = set(tried["survivors"])
    in_functions = {"holds: not is_pressed -> is_pressed", "Brake.press: self.count += 1 -> self.count = 1"}
    at_edges = {"module: 3 -> 4", "holds: speed > LIMIT -> speed >= LIMIT", "Brake.is_worn: 2 -> 1"}
    assert survivors & (in_functions | at_edges) == set()
    assert {"holds: speed > LIMIT and (not is_pressed) -> speed > LIMIT", "module: 'held' -> '~held'"} <= survivors


def test_what_no_test_carries_out_is_named(tried):  # R-X24
    assert tried["missing"] == ["line: self.count = 0", "branch: if self.count > 9: -> self.count = 0"]
    assert any(name.startswith("Brake.press: 9 -> ") for name in tried["survivors"])


def test_of_a_file_that_does_much_else_only_its_core_is_tried(tmp_path):  # R-X24
    tried = trial_of_brake(tmp_path, ["Brake.is_worn"])
    assert (tried["mutants"], tried["survivors"], tried["missing"], tried["failure"]) == (5, [], [], "")


def test_a_trial_that_breaks_off_has_failed(tmp_path):  # R-X24
    tried = trial_of_brake(tmp_path, conftest="def pytest_collection_finish():\n    raise OSError\n")
    assert tried["failure"] == "the trial itself has failed"


def test_survivors_without_a_reason_and_reasons_without_a_survivor_are_wrong():  # R-X24
    trials = [Findings("a.py", 3, ["x", "y"], ["branch 1: if z -> w"])]
    named = {"a.py": {"x": "it is the same", "gone": "no more"}, "b.py": {}}
    assert list(safety_core.complaints(trials, named, ["a.py"], is_whole=True)) == [
        "a.py: survives: y",
        "a.py: never carried out: branch 1: if z -> w",
        "a.py: strike it, it is no more: gone",
        "survivors.toml: b.py is not of the safety core",
    ]
    sampled = list(safety_core.complaints(trials, named, ["a.py", "b.py"], is_whole=False))
    assert sampled == ["a.py: survives: y", "a.py: never carried out: branch 1: if z -> w"]


def test_a_trial_that_fails_is_wrong_whatever_survives():
    trials = [Findings("a.py", failure="tests/test_a.py::test_it")]
    assert list(safety_core.complaints(trials, {}, ["a.py"], is_whole=True)) == ["a.py: tests/test_a.py::test_it"]


def test_every_file_of_the_core_is_there_with_its_tests_and_every_reason_says_something():  # R-X24
    core = safety_core.files(ROOT)
    assert all((ROOT / path).is_file() for core_file in core.values() for path in (core_file.path, *core_file.tests))
    assert all(len(reason) >= 8 for named in safety_core.reasons().values() for reason in named.values())
