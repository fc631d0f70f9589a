from typing import ClassVar

import msgspec
import pytest

from onika.desk.plan.preparation import PreparedRun
from onika.desk.run.settings import RunSettings
from onika.desk.sweep import cluster_work as room, swept_program
from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.cluster_work import KeptRuntimes, carry_out, decode_answer, own_build
from onika.desk.sweep.design import SweepDesign
from onika.desk.sweep.swept_program import SweptProgram
from onika.wire.plan import Plan


def program(name):
    prepared = PreparedRun(name, None, Plan(name, (), ()), (), ())
    return swept_program.encode(SweptProgram.of(SweepDesign(RunSettings(name), range(1)), prepared))


class Runtime:
    """A warm runtime that answers by the name of its program."""

    made: ClassVar[list["Runtime"]] = []

    def __init__(self, prepared, site):
        self.name = prepared.name
        self.done = 0
        self.is_closed = False
        Runtime.made.append(self)

    def do(self, case, settings, limit_s):
        assert settings.seed == settings.shake == case.seed
        if case.seed < 0:
            raise RuntimeError("a fault of ours")
        self.done += 1
        return CaseResult(case, "completed", hash=self.name)

    def close(self):
        self.is_closed = True


@pytest.fixture
def made(monkeypatch):
    monkeypatch.setattr(room, "WarmRuntime", Runtime)
    monkeypatch.setattr(room, "_kept", KeptRuntimes())
    Runtime.made = []
    return Runtime.made


def answer(name, seed, build=None):
    return decode_answer(carry_out(program(name), msgspec.msgpack.encode(Case(seed)), build or own_build()))


def test_one_runtime_does_all_cases_of_a_program(made):  # R-X23
    assert [answer("stack", seed).result for seed in range(3)] == [
        CaseResult(Case(seed), "completed", hash="stack") for seed in range(3)
    ]
    assert [runtime.done for runtime in made] == [3]


def test_a_runtime_of_another_program_ends_before_the_next_begins(made):  # R-X23
    answer("stack", 0)
    assert answer("unstack", 0).result.hash == "unstack"
    assert [runtime.is_closed for runtime in made] == [True, False]


def test_a_runtime_in_which_something_of_ours_was_wrong_is_not_used_again(made):  # R-X23
    with pytest.raises(RuntimeError):
        answer("stack", -1)
    answer("stack", 1)
    assert [runtime.is_closed for runtime in made] == [True, False]


def test_whoever_has_other_code_runs_nothing_and_says_which(made):  # R-X23
    refused = answer("stack", 0, "another")
    assert refused.result is None
    assert refused.build == own_build() != "another"
    assert refused.worker
    assert made == []
