from kit.desk.installed_fixture import InstalledFixture
from onika.store.shipped import is_shipped


def test_what_is_installed_is_a_copy_of_its_own_before_which_the_users_own_comes(tmp_path, monkeypatch):
    desk = InstalledFixture(tmp_path, monkeypatch)
    assert [base.path.name for base in desk.site.directories] == ["onika", "boxes", "generic"]
    assert is_shipped(desk.generic.path) and not is_shipped(desk.own.path) and desk.told == ()
    assert desk.installed_files() == desk.before and "generic/module/pd.py" in desk.before
    desk.look()
    assert desk.says == []
