import pytest

from onika.cli import main
from onika.process import confinement


@pytest.fixture(autouse=True)
def state(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


def test_without_a_kernel_that_confines_nothing_is_opened(capsys, monkeypatch):  # R-X25
    monkeypatch.setattr(confinement, "level", lambda: 0)
    assert main(["class", "--seats", "2"]) == 2
    assert "--unconfined" in capsys.readouterr().err


def test_others_are_let_in_over_tls_only(capsys):  # R-X25
    assert main(["class", "--unconfined", "--listen", "0.0.0.0"]) == 2
    assert [line.partition(":")[0] for line in capsys.readouterr().err.splitlines()] == ["--cert", "--key"]


@pytest.mark.parametrize(
    "words",
    [
        ["--seats", "0"],
        ["--seats", "61"],
        ["--memory", "x"],
        ["--name", "../x"],
        ["--cert", "x"],
        ["--test", "/none"],
        ["--expect", "LAMP"],
        ["--listen", "h", "--port", "1"],
    ],
)
def test_what_makes_no_sense_is_said(words, capsys):
    with pytest.raises(SystemExit):
        main(["class", "--unconfined", *words])
    assert "error" in capsys.readouterr().err
