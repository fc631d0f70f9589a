"""A test of tests: of a kept assembly every mistake that people make is caught, and what changes nothing is passed."""

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest

import onika
from kit.plans.mutants import mutants
from onika.cli import main
from onika.desk.trial.account import give_account
from onika.desk.trial.judging import judge
from onika.desk.trial.trial import limit_of, read, settings_of, try_all
from onika.files import appl, onk
from onika.store.site import open_site

pytestmark = pytest.mark.site

KEPT = Path(__file__).parents[1] / "data" / "kept" / "assemble.test"
LABS = Path(onika.__file__).parent / "labs"
SITE = open_site([], {}, None)
SYNTAX = SITE.syntax()[0]
ASSEMBLE = appl.read((LABS / "boxes" / "appl" / "assemble.appl").read_text(), "assemble", "assemble.appl", SYNTAX)[0]
JOBS = ("jmoveC", "cmoveC", "opengripC", "closegripC")
WORKERS = os.cpu_count() or 1


def right(name):
    """The job of the right arm that does what this one of the left arm does."""
    name = f"{name[:-1]}_rightC"
    return onk.read((LABS / "puma" / "dict" / f"{name}.onk").read_text(), name, name, SYNTAX)[0]


MUTANTS = list(mutants(ASSEMBLE, SYNTAX, {name: right(name) for name in JOBS}))


def verdicts(chosen, folder):
    """What the kept test says of these mutants."""
    kept, faults = read(KEPT)
    assert faults == ()

    def judged(numbered):
        number, mutant = numbered
        path = folder / str(number) / "appl" / "assemble.appl"
        path.parent.mkdir(parents=True)
        path.write_text(appl.write(mutant.application))
        settings = replace(settings_of(kept), name=str(path))
        return mutant.text, judge(kept, give_account(settings, SITE, limit_of(kept)))

    with ThreadPoolExecutor(WORKERS) as pool:
        return dict(pool.map(judged, enumerate(chosen)))


def test_a_kept_assembly_is_passed_a_lift_may_be_left_out_and_a_wrong_target_is_caught(
    tmp_path, monkeypatch, capsys
):  # R-X07
    texts = ("wrong target: action 7 ", "missing jmoveC: action 5 ")
    results = verdicts([mutant for mutant in MUTANTS if str(mutant.text).startswith(texts)], tmp_path)
    assert [verdict.is_passed for verdict in results.values()] == [True, False]
    lifted, target = results.values()
    assert any("action 5 (jmoveC box2_aj) is left out" in str(note) for note in lifted.notes)
    assert any("are not done, from action 7 (cmoveC box2_ex) on" in str(failure) for failure in target.failures)
    report = tmp_path / "out.xml"
    assert main(["test", str(KEPT), "--junit", str(report)]) == 0
    assert "1 of 1 passed" in capsys.readouterr().out
    assert ElementTree.parse(report).getroot().get("failures") == "0"


def test_a_run_is_kept_from_the_command_line_and_done_again(tmp_path, capsys):  # R-X07
    path = tmp_path / "go_home.test"
    assert main(["run", "go_home", "--virtual", "--keep-test", str(path)]) == 0
    assert "test: " in capsys.readouterr().err
    kept, faults = read(path)
    assert faults == ()
    assert [action.name for action in kept.flows[0].actions]
    assert main(["test", str(tmp_path)]) == 0


@pytest.mark.slow
def test_a_kept_assembly_is_passed_by_every_run_that_is_as_good():  # R-X07
    done = list(try_all([KEPT], SITE, workers=WORKERS, shakes=10))
    assert [shipped.name for shipped in done if not shipped.verdict.is_passed] == []
    assert len(done) == 11


@pytest.mark.slow
def test_every_harmful_mutant_of_the_assembly_is_caught(tmp_path):  # R-X07
    results = verdicts(MUTANTS, tmp_path)
    passed = {text for text, verdict in results.items() if verdict.is_passed}
    actions = read(KEPT)[0].flows[0].actions
    ways = [(at, action.name) for at, action in enumerate(actions, start=1) if action.is_on_way]
    assert passed <= {f"missing {name.partition(' ')[0]}: action {at} ({name})" for at, name in ways}
    assert "missing jmoveC: action 5 (jmoveC box2_aj)" in passed  # a lift
    assert all(any("is left out" in str(note) for note in results[text].notes) for text in passed)
