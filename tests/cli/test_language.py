"""The command line speaks the language of --lang, else of ONIKA_LANG, else English."""

import os

import pytest

from onika.cli import main
from onika.cli.language import language, say, speaking
from onika.words.reason import Reason


@pytest.fixture(autouse=True)
def silent(monkeypatch):
    monkeypatch.delenv("ONIKA_LANG", raising=False)


@pytest.mark.parametrize(("variable", "expected"), [("es", "es"), ("en", "en"), ("tlh", "en"), ("", "en")])
def test_the_variable_names_the_language(monkeypatch, variable, expected):
    monkeypatch.setenv("ONIKA_LANG", variable)
    assert language() == expected


def test_a_language_is_spoken_for_a_while():
    with speaking("es"):
        assert os.environ["ONIKA_LANG"] == "es"
        assert say(Reason.of("cli.language_option", languages=(), default="en")).startswith("el idioma")
        with speaking(None):
            assert language() == "es"
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
