from pathlib import Path

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.replacing import kept, present_text
from onika.store.replaced_texts import ReplacedTexts


def test_only_what_was_there_and_is_another_now_is_kept(tmp_path: Path) -> None:  # R-X10
    outside, path = EnvironmentFixture(tmp_path).surroundings, tmp_path / "pd.py"
    assert present_text(path) == ""
    path.write_text("now")
    assert kept(path, "", outside) == () == kept(path, "now", outside)
    assert kept(path, "before", outside) == ()
    assert [text.text for text in ReplacedTexts(tmp_path / "state").listed()] == ["before"]


def test_where_it_cannot_be_kept_a_line_says_so(tmp_path: Path) -> None:  # R-B07
    outside, path = EnvironmentFixture(tmp_path).surroundings, tmp_path / "pd.py"
    path.write_text("now")
    (tmp_path / "state").write_text("no folder")
    (line,) = kept(path, "before", outside)
    assert line.level == "warning" and line.text.key == "store.not_kept"
