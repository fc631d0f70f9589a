import argparse

import pytest

from onika.cli.language import speaking
from onika.words import argument_words
from onika.words.catalogue import sentences


@pytest.fixture
def parser():
    argument_words.translate()
    with speaking("es"):
        parser = argparse.ArgumentParser(prog="onika")
        parser.add_argument("file", choices=("a", "b"))
        parser.add_argument("--count", type=int, nargs=2)
        yield parser


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["--help"], "uso: onika"),
        (["--help"], "muestra esta ayuda"),
        ([], "onika: error: faltan estos argumentos: file"),
        (["c"], "argumento file: no hay tal opción: 'c'"),
        (["a", "b"], "argumentos que no se entienden: b"),
        (["a", "--count", "1"], "argumento --count: se esperaban 2 valores"),
        (["a", "--count", "1", "x"], "valor que no es int: 'x'"),
    ],
)
def test_a_parser_speaks_the_language_of_the_command_line(parser, words, sentence, capsys):  # R-G03
    with pytest.raises(SystemExit):
        parser.parse_args(words)
    printed = capsys.readouterr()
    assert sentence in printed.out + printed.err


def test_in_english_it_says_what_it_always_says(capsys):
    argument_words.translate()
    with speaking("en"), pytest.raises(SystemExit):
        argparse.ArgumentParser(prog="onika").parse_args(["more"])
    assert capsys.readouterr().err.endswith("onika: error: unrecognized arguments: more\n")


def test_every_word_for_a_parser_is_asked_for():
    request = {key.removeprefix("cli.") for key in argument_words._KEYS}
    assert request == {name for name in sentences("en", "cli") if name.startswith("arg_")}
