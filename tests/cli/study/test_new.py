from onika.cli import main


def test_a_kit_is_made_and_never_written_over(tmp_path, capsys):  # R-H05
    assert main(["study", "new", str(tmp_path / "folk")]) == 0
    paper = tmp_path / "folk" / "papers" / "es" / "1-consent.html"
    paper.write_text("ours")
    assert main(["study", "new", str(tmp_path / "folk")]) == 2
    assert paper.read_text() == "ours"
    assert "is there already" in capsys.readouterr().err
