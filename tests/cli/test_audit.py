import os

import pytest

from onika.cli import main
from onika.files import trail
from onika.store.audit_trail import AuditTrail, open_free


@pytest.fixture
def path(tmp_path):
    audit = AuditTrail(tmp_path / "audit.log")
    for what in ("Take", "Stop", "Release"):
        audit.note(what, who="ann#2")
    audit.close()
    return tmp_path / "audit.log"


def test_a_trail_is_shown_and_found_whole(path, capsys):  # R-X12
    assert main(["audit", str(path)]) == 0
    *records, verdict = capsys.readouterr().out.splitlines()
    assert [line.split()[-1] for line in records] == ["Take", "Stop", "Release"]
    assert verdict.startswith("3 records, whole; head ")


def test_a_changed_trail_is_named_with_its_line(path, capsys):  # R-X12
    path.write_bytes(path.read_bytes().replace(b"Stop", b"Look"))
    assert main(["audit", str(path)]) == 1
    captured = capsys.readouterr()
    assert f"{path}:2:" in captured.err
    assert "NOT WHOLE" in captured.out


def test_lines_taken_off_the_end_show_by_the_head_that_was_noted(path, capsys):  # R-X12
    main(["audit", str(path), "--quiet"])
    head = capsys.readouterr().out.split()[-1]
    assert main(["audit", str(path), "--head", head]) == 0
    path.write_bytes(b"".join(path.read_bytes().splitlines(keepends=True)[:-1]))
    capsys.readouterr()
    assert main(["audit", str(path), "--last", "1", "--head", head]) == 1
    captured = capsys.readouterr()
    assert "taken off its end" in captured.err
    assert len(captured.out.splitlines()) == 2


def test_the_trails_of_runtimes_that_ran_side_by_side_are_all_shown(tmp_path, monkeypatch, capsys):  # R-X12
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    folder = trail.usual_path(os.environ).parent
    first, second = open_free(folder / "audit.log"), open_free(folder / "audit.log")
    for audit, what in ((first, "Take"), (second, "Stop")):
        audit.note(what, who="ann#2")
        audit.close()
    (folder / "audit-2.log.1").write_bytes(b"")
    (folder / "audit-old.log").write_bytes(b"no trail")
    assert main(["audit"]) == 0
    output = capsys.readouterr().out.splitlines()
    assert [line for line in output if line.endswith(":")] == [f"{folder / 'audit.log'}:", f"{folder / 'audit-2.log'}:"]
    assert [line.split()[-1] for line in output if "ann#2" in line] == ["Take", "Stop"]
    (folder / "audit-2.log").write_bytes((folder / "audit-2.log").read_bytes().replace(b"Stop", b"Look"))
    assert main(["audit", "--quiet"]) == 1


def test_where_there_is_none_it_says_so(tmp_path, capsys):
    assert main(["audit", str(tmp_path / "no")]) == 2
    assert "found none" in capsys.readouterr().err
