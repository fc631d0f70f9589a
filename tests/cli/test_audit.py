import pytest

from onika.cli import main
from onika.host.sessions.audit_trail import AuditTrail


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


def test_where_there_is_none_it_says_so(tmp_path, capsys):
    assert main(["audit", str(tmp_path / "no")]) == 2
    assert "found none" in capsys.readouterr().err
