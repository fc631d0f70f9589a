import pytest

from onika.cli import main
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped


@pytest.fixture
def own(tmp_path, monkeypatch):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    base = BaseDirectory(tmp_path / "onika")
    base.task_file("pd").parent.mkdir(parents=True)
    text = (shipped() / "generic" / "module" / "pd.rmod").read_text()
    base.task_file("pd").write_text("# mine\n" + text)
    return base


def test_what_is_ones_own_over_what_is_shipped_is_listed_and_compared(own, capsys):  # R-B08
    assert main(["own"]) == 0
    assert capsys.readouterr().out == f"{own.task_file('pd')}: yours, over generic\n"
    assert main(["own", str(own.task_file("pd"))]) == 0
    assert "+# mine" in capsys.readouterr().out.splitlines()


def test_going_back_keeps_what_was_there(own, tmp_path, capsys):  # R-X10
    assert main(["own", str(own.task_file("pd")), "--back"]) == 0
    assert "can be brought back" in capsys.readouterr().out and not own.task_file("pd").exists()
    (kept,) = (tmp_path / "state" / "onika" / "replaced").iterdir()
    assert "# mine" in kept.read_text()
    assert main(["own", str(own.task_file("pd")), "--back"]) == 1
    assert "stands before no file" in capsys.readouterr().err
