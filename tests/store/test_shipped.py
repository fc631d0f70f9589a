from pathlib import Path

from onika.store.shipped import is_shipped, shipped, shipped_directories


def test_the_shipped_directories_hold_laboratories_and_no_preferences() -> None:
    assert shipped() / "prefs" not in shipped_directories()
    assert all(path.parent == shipped() for path in shipped_directories())


def test_a_link_that_leads_to_what_is_shipped_is_shipped_too(tmp_path: Path) -> None:
    (tmp_path / "pd.rmod").symlink_to(shipped() / "generic" / "module" / "pd.rmod")
    (tmp_path / "self.rmod").symlink_to(tmp_path / "self.rmod")
    assert is_shipped(tmp_path / "pd.rmod") and is_shipped(shipped() / "generic" / "module" / "new.rmod")
    assert not is_shipped(tmp_path / "self.rmod") and not is_shipped(tmp_path / "none.rmod")
