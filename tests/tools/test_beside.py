import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).parents[2] / "tools" / "bench"


@pytest.fixture(autouse=True)
def importable(monkeypatch):
    monkeypatch.syspath_prepend(BENCH)


def outcome(ours, its, **peer):
    """A contest in which both did these figures."""
    from beside.contest import Contest, Entrant, Outcome, Score

    def score(name, figures, **more):
        entrant = Entrant(name, name, goal=0.5)
        return Score(entrant, "1.0", rounds=[{"figure": figure} for figure in figures], **more)

    contest = Contest("key", "Who is quicker", "us", Entrant("Onika", ""), (), 1, 1)
    return Outcome(contest, score("Onika", ours), (score("peer", its, **peer),))


def test_the_loop_comes_to_where_a_plain_loop_puts_the_joint():
    from beside.loop.blocks import check
    from beside.loop.onika_blocks import Loop

    loop = Loop()
    loop.step(120)
    check({"steps": 120, "position": loop.position})


def test_the_loop_in_c_comes_there_too():
    from beside.loop import onika_c_blocks
    from beside.loop.blocks import check
    from beside.loop.onika_blocks import measured

    if not any(map(shutil.which, ("cc", "gcc", "clang"))):
        pytest.skip("no C compiler is installed")
    check(measured(onika_c_blocks.MODULES)(120))


def test_a_contestant_that_computes_something_else_takes_no_part():
    from beside.contestant import Absent
    from beside.loop.blocks import check

    with pytest.raises(Absent, match="expected the joint at"):
        check({"steps": 120, "position": [0.0] * 6})


def test_a_sweep_carries_out_every_task_once():
    from beside.sequence.onika_sweep import Sweep

    sweep = Sweep(5)
    assert sweep.run(7) > 0
    assert sweep.cycles() == 35


def test_the_application_is_measured_over_all_its_actions():
    from beside.sequence.onika_application import Application

    assert Application(3).run() > 0


def test_lateness_is_told_by_its_99_percent_median_and_most():
    from beside.punctuality.lateness import figures

    summary = figures(list(range(1000, 101_000, 1000)), 2)
    assert (summary["median"], summary["figure"], summary["most"], summary["missed"]) == (51.0, 100.0, 100.0, 2.0)
    with pytest.raises(RuntimeError, match="expected cycles"):
        figures([], 0)


def test_a_hop_that_brings_back_something_else_is_an_error():
    from beside.hop.vector import hops

    assert hops(list, 10)["figure"] >= 0
    with pytest.raises(RuntimeError, match="expected"):
        hops(lambda values: [*values[:-1], -1.0], 10)


def test_a_ratio_is_the_median_over_rounds_side_by_side():
    verdict = outcome([1.0, 2.0, 9.0], [2.0, 4.0, 3.0])
    assert verdict.ratio(verdict.peers[0]) == 0.5


def test_rows_that_lose_are_told_as_plainly_as_rows_that_win():
    from beside.page import outcome_table

    assert "| 0.50       | 0.50 | Onika ahead, goal met |" in outcome_table(outcome([1.0], [2.0]))
    assert "| Onika ahead, goal **missed** |" in outcome_table(outcome([3.0], [4.0]))
    assert "| Onika behind, goal **missed** |" in outcome_table(outcome([4.0], [2.0]))


def test_a_peer_that_takes_no_part_is_a_row_with_its_reason():
    from beside.page import outcome_table

    assert "not measured: no wheel for this Python" in outcome_table(
        outcome([1.0], [], absent="no wheel for this Python")
    )


def test_a_page_keeps_what_stands_around_the_measured_tables():
    from beside.page import BEGIN, END, put

    page = f"before\n\n{BEGIN}\nold\n{END}\nafter\n"
    assert put(page, "new\n") == f"before\n\n{BEGIN}\n\nnew\n\n{END}\nafter\n"
    for broken in ("nothing", f"{END}{BEGIN}", f"{BEGIN}{BEGIN}{END}", f"{BEGIN}{END}{END}"):
        with pytest.raises(ValueError, match="expected"):
            put(broken, "new")


def test_the_page_of_benchmarks_has_its_place_for_them():
    from beside.page import put

    put((BENCH.parents[1] / "docs" / "benchmarks.md").read_text(), "")


def test_a_page_is_not_written_of_some_rows_or_tiny_rounds(tmp_path, capsys):
    from beside.__main__ import main

    for words in (["--quick"], ["--alone"], ["--only", "loop"]):
        with pytest.raises(SystemExit):
            main([*words, "--write", str(tmp_path / "page.md")])
    assert "all rows" in capsys.readouterr().err


def test_every_module_that_takes_part_is_there():
    from beside.contests import CONTESTS, LADDERS
    from beside.peers import PACKAGES

    entrants = [entrant for contest in CONTESTS for entrant in (contest.ours, *contest.peers)]
    for module in [*(entrant.module for entrant in entrants), *(ladder.module for ladder in LADDERS)]:
        assert BENCH.joinpath(*module.split(".")).with_suffix(".py").exists(), module
    assert {entrant.package for entrant in entrants} - {""} == PACKAGES.keys()


@pytest.mark.site
def test_a_contestant_that_cannot_start_says_why():
    from beside.contestant import Absent, Contestant

    with pytest.raises(Absent, match=r"No module named beside\.nobody"):
        Contestant("beside.nobody")


@pytest.mark.slow
@pytest.mark.site
def test_all_rows_of_our_own_are_measured():
    words = [sys.executable, "-m", "beside", "--quick", "--alone", "--rounds", "1"]
    search = os.pathsep.join((str(BENCH), str(BENCH.parents[1] / "tests"), *sys.path))
    ran = subprocess.run(words, env=os.environ | {"PYTHONPATH": search}, capture_output=True, text=True, check=True)
    tables = {part.partition("\n")[0]: part for part in ran.stdout.split("### ")[1:]}
    refused = [title for title, table in tables.items() if "Not measured" in table]
    assert len(tables) == 9
    assert refused == [] or (len(refused) == 1 and "SCHED_FIFO is not granted" in tables[refused[0]])
