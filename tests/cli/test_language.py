"""The command line speaks the language of --lang, else of ONIKA_LANG, else English."""

import os

import pytest

from onika.cli import main
from onika.cli.commands import COMMANDS
from onika.cli.language import say, speaking
from onika.words.own_language import own_language
from onika.words.reason import Reason


@pytest.fixture(autouse=True)
def silent(monkeypatch):
    monkeypatch.delenv("ONIKA_LANG", raising=False)


def test_a_language_is_spoken_for_a_while():
    with speaking("es"):
        assert os.environ["ONIKA_LANG"] == "es"
        assert say(Reason.of("cli.language_option", languages=(), default="en")).startswith("el idioma")
        with speaking(None):
            assert own_language() == "es"
    assert "ONIKA_LANG" not in os.environ


@pytest.mark.parametrize("words", [["--lang", "es", "--help"], ["--lang=es", "--help"]])
def test_the_option_stands_before_the_command(words, capsys):
    with pytest.raises(SystemExit):
        main(words)
    assert "el idioma de los mensajes" in " ".join(capsys.readouterr().out.split())


@pytest.mark.parametrize("words", [["--lang", "tlh", "check"], ["--lang"]])
def test_a_language_that_is_not_known_is_refused(words, capsys):
    with pytest.raises(SystemExit):
        main(words)
    assert "--lang" in capsys.readouterr().err


@pytest.mark.parametrize("command", sorted(COMMANDS))
def test_every_command_says_in_spanish_what_it_takes(command, capsys):  # R-G03
    with pytest.raises(SystemExit):
        main(["--lang", "es", command, "--help"])
    spanish = capsys.readouterr().out
    with pytest.raises(SystemExit):
        main([command, "--help"])
    assert capsys.readouterr().out != spanish


def test_a_check_is_summed_up_in_spanish(capsys):
    assert main(["--lang", "es", "check", "nowhere.conf"]) == 1
    assert capsys.readouterr().out.splitlines()[-1].endswith("1 fallo")
