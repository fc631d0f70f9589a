from pathlib import Path

import pytest

from onika.desk.plan.loop_counters import counts_loops
from onika.desk.plan.preparation import prepare_run
from onika.store.shipped import shipped
from onika.store.site import open_site

MODULE = "class M(Module):\n{ports}    def cycle(self):\n{cycle}"
SITE = open_site([], {}, None)
REPEAT = next(shipped().rglob("repeat.py"))


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
