from pathlib import Path

import pytest

from onika.desk.plan.application_text import convert
from onika.desk.plan.loop_counters import counts_loops
from onika.desk.plan.preparation import prepare_run
from onika.files import appl
from onika.store.shipped import shipped
from onika.store.site import open_site

MODULE = "class M(Module):\n{ports}    def cycle(self):\n{cycle}"
SITE = open_site([], {}, None)
REPEAT = next(shipped().rglob("repeat.py"))
INNER = """  REPEAT inner
    OPEN HAND opengripC
    CLOSE HAND closegripC
    DO repeatC TO three
  UNTIL DONE
"""
TWICE = f"BEGIN\n  REPEAT outer\n  NOP noop\n{INNER}  DO repeatC TO OUTER\n  UNTIL DONE\nEND\n"
BRANCH = f"  DO lamp_litC\n  CASE OF\n  BEGIN\n{INNER}  END\n  BEGIN\n  NOP noop\n  END\n  END CASE\n"
IN_A_BRANCH = f"BEGIN\n  REPEAT outer\n  NOP noop\n{BRANCH}  DO repeatC TO OUTER\n  UNTIL DONE\nEND\n"
APART = f"BEGIN\n{INNER}{INNER.replace('inner', 'second')}END\n"


def faults_of(folder, text):
    """What keeps a program from running that is written in the words of AL."""
    (folder / "loops.al").write_text(text)
    converted = convert(folder / "loops.al", None, SITE)
    (folder / "loops.appl").write_text(appl.write(converted.application))
    return [fault.reason.key for fault in prepare_run(str(folder / "loops.appl"), SITE).faults]


def code(folder, cycle, ports=""):
    path = folder / "m.py"
    path.write_text(MODULE.format(ports=ports, cycle=cycle))
    return path


def application(folder, *changes):
    """The waving three times, changed."""
    text = next(shipped().rglob("wave_three.appl")).read_text()
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    path = folder / "wave.appl"
    path.write_text(text)
    return [str(fault.reason) for fault in prepare_run(str(path), SITE).faults]


def test_a_module_that_does_nothing_but_return_whether_to_go_on_counts_loops(tmp_path):
    assert counts_loops(REPEAT)
    assert counts_loops(code(tmp_path, "        return finish(loop=self.left > 0)\n"))


@pytest.mark.parametrize(
    ("cycle", "ports"),
    [
        ("        return finish()\n", ""),
        ("        return finish(loop=True)\n", ""),
        ("        return finish(loop=self.A > 0)\n", '    A = InVar("int", "-", "a")\n'),
        ("        if self.now:\n            return finish()\n        return finish(loop=self.left > 0)\n", ""),
        ("        return (\n", ""),
    ],
)
def test_other_modules_do_not(tmp_path, cycle, ports):
    assert not counts_loops(code(tmp_path, cycle, ports))


def test_what_is_not_there_counts_nothing():
    assert not counts_loops(Path("/nowhere/m.py"))


def test_a_job_that_counts_and_decides_no_loop_is_a_fault(tmp_path):  # R-E01
    assert application(tmp_path) == []
    no_loop = ("WHILETAG    wave\nWHILETEST   no\n", ""), ("WHILETAG    wave\nWHILETEST   yes\n", "")
    (reason,) = application(tmp_path, *no_loop)
    assert "repeatC" in reason and "nothing is repeated" in reason
    turned = ("WHILETEST   yes", "WHILETEST   later"), ("WHILETEST   no", "WHILETEST   yes"), ("later", "no")
    assert any("nothing is repeated" in reason for reason in application(tmp_path, *turned))


@pytest.mark.parametrize(("outer", "is_told"), [("three", True), ("ten", False)])
def test_loops_within_each_other_that_count_to_one_number_are_a_fault(tmp_path, outer, is_told):  # R-E01, R-D13
    assert faults_of(tmp_path, TWICE.replace("OUTER", outer)) == (["desk.counts_alike"] if is_told else [])


@pytest.mark.parametrize(("outer", "is_told"), [("three", True), ("ten", False)])
def test_so_are_those_of_which_one_stands_in_a_branch_of_the_other(tmp_path, outer, is_told):  # R-E01, R-D13
    assert faults_of(tmp_path, IN_A_BRANCH.replace("OUTER", outer)) == (["desk.counts_alike"] if is_told else [])


def test_loops_one_after_the_other_may_count_alike(tmp_path):  # R-D13
    assert faults_of(tmp_path, APART) == []
