"""`onika study report`, as a user enters it."""

import sys

import pytest

from kit.study.log_text import assembly
from onika.cli import main


def test_the_source_is_reported_with_its_probability_and_table_4(tmp_path, capsys):  # R-H03
    assert main(["study", "report", "--source", "-o", str(tmp_path / "out")]) == 0
    assert "F(2, 18) = 3.096, p = 6.99 %" in capsys.readouterr().out
    page = (tmp_path / "out" / "report.html").read_text()
    for number in ("-3.2796", "-0.7369", "1.8058", "-6.1984", "-3.0539", "0.0907", "-5.5214", "-2.3170", "0.8874"):
        assert f"<td>{number}</td>" in page
    assert (tmp_path / "out" / "pairs.csv").exists()


def test_what_could_not_be_read_is_told_and_the_rest_reported(tmp_path, capsys):  # R-H02
    for name in ("p1", "p2"):
        (tmp_path / f"{name}.log").write_text(assembly(4.0))
    (tmp_path / "p3.log").write_text("garbage\n" + assembly(5.0))
    assert main(["study", "report", str(tmp_path)]) == 1
    said = capsys.readouterr()
    assert "p3.log:1: expected 7 columns, parted by tabs, found 1" in said.err
    assert "no comparison" in said.out
    assert "p3" in (tmp_path / "report" / "report.html").read_text()
    assert main(["study", "report", str(tmp_path)]) == 1  # the report of before is no part of the study


def test_a_folder_without_subjects_and_no_folder_are_refused(tmp_path, capsys):  # R-H02
    assert main(["study", "report", str(tmp_path)]) == 2
    assert main(["study", "report", str(tmp_path / "none")]) == 2
    (tmp_path / "file").write_text("")
    assert main(["study", "report", "--source", "-o", str(tmp_path / "file")]) == 1
    with pytest.raises(SystemExit) as ended:
        main(["study", "report"])
    assert ended.value.code == 2
    assert capsys.readouterr().out == ""


def test_without_scipy_the_extra_is_named(tmp_path, capsys, monkeypatch):  # R-H03
    monkeypatch.setitem(sys.modules, "onika.study.compared", None)
    assert main(["study", "report", "--source", "-o", str(tmp_path / "out")]) == 2
    assert "onika[study]" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
