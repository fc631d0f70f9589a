from kit.study.log_text import assembly
from onika.cli import main


def test_a_session_goes_from_its_preparation_to_the_report(tmp_path, capsys):  # R-H09
    study = tmp_path / "folk"
    main(["study", "new", str(study)])
    main(["study", "prepare", str(study), "s1", "--variant", "both", "--no-calibration"])
    diary = study / "sessions" / "s1" / ".local" / "state" / "onika" / "diary"
    assert main(["study", "end", str(study), "s1"]) == 2
    diary.mkdir(parents=True)
    (diary / "a.log").write_text(assembly(4.0))
    assert main(["study", "end", str(study), "s1"]) == 0
    assert main(["study", "end", str(study), "s1"]) == 2
    assert main(["study", "report", str(study)]) == 0
    assert "mean_selection_s: all 4" in capsys.readouterr().out
