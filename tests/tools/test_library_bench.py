import runpy
from pathlib import Path

from onika.store.base_directory import BaseDirectory

TOOL = str(Path(__file__).parents[2] / "tools" / "bench" / "library.py")


def test_a_small_round_of_it_measures_and_prints(capsys):
    runpy.run_path(TOOL)["main"](["--most", "100", "--rounds", "1"])
    head, *rows = capsys.readouterr().out.splitlines()
    assert head.split() == ["tasks", "left", "out", "ms", "us/task", "ratio"]
    assert [row.split()[:2] for row in rows] == [["10", "0"], ["100", "1"]]
    assert float(rows[0].split()[-1]) == 1.0


def test_every_damage_breaks_a_file(tmp_path):
    tool = runpy.run_path(TOOL)
    text = tool["_TASK"].format(number=1, rate=1)
    base = BaseDirectory(tmp_path)
    (tmp_path / "module").mkdir()
    for damage in (("", ""), *tool["_DAMAGES"]):
        base.task_file("t").write_text(text.replace(*damage, 1))
        assert (base.task("t")[0] is None) == bool(damage[0]), damage
