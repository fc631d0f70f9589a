import shlex

from onika.cli import main


def test_how_the_page_is_started_is_told_and_leads_nowhere_out_of_the_home(tmp_path, capsys):  # R-H09
    study = tmp_path / "folk for us"
    assert main(["study", "new", str(study)]) == 0
    capsys.readouterr()
    assert main(["study", "prepare", str(study), "s1", "--variant", "both"]) == 0
    said = capsys.readouterr().out
    command = shlex.split(next(line for line in said.splitlines() if line.startswith("  env ")))
    assert f"HOME={study / 'sessions' / 's1'}" in command
    assert "XDG_STATE_HOME" in command
    assert "choose both" in said
    assert shlex.quote(str(study)) in said.splitlines()[-1]


def test_what_cannot_be_prepared_is_refused(tmp_path, capsys):  # R-H09
    assert main(["study", "prepare", str(tmp_path / "none"), "s1", "--variant", "both"]) == 2
    assert main(["study", "prepare", str(tmp_path), "s1"]) == 2
    assert capsys.readouterr().out == ""
    assert [*tmp_path.iterdir()] == []
