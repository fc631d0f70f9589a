import runpy
from pathlib import Path

from kit.study import assemblies

TOOL = str(Path(__file__).parents[2] / "tools" / "bench" / "learn.py")
KEPT = Path(__file__).parents[1] / "data" / "assemblies"


def test_kept_logs_are_told_beside_the_source_and_what_nobody_did_apart(capsys):  # R-H06
    assert runpy.run_path(TOOL)["main"]([]) == 0
    rows = capsys.readouterr().out.splitlines()
    person = next(row for row in rows if row.startswith("thesis_pt3"))
    assert person.split()[1:5] == ["13", "5.62", "3.36", "–"]
    assert any(row.startswith("people, mean selection") and "5.62 s   (source: 6.1 s)" in row for row in rows)
    assert sum(row.startswith("synthetic_") for row in rows) == len(assemblies.SUBJECTS)
    assert any(row.startswith("synthetic, building") and "257 to 868 s" in row for row in rows)


def test_where_there_is_no_log_it_says_so(tmp_path, capsys):
    assert runpy.run_path(TOOL)["main"]([str(tmp_path)]) == 1
    assert "found none" in capsys.readouterr().out


def test_synthetic_logs_are_those_that_their_program_writes():
    for name, (seed, selection_s, failures) in assemblies.SUBJECTS.items():
        kept = (KEPT / f"synthetic_{name}.log").read_text(encoding="utf-8")
        assert kept == assemblies.log(seed, selection_s, failures)
