"""One rule for what shipped modules say: every sentence that stands in their code has its Spanish beside it."""

import ast
from functools import cache
from pathlib import Path

import pytest

from onika.store.module_catalogue import read

LABS = Path(__file__).parents[2] / "src" / "onika" / "labs"
MODULES = sorted(LABS.glob("*/module/*.py"))
SAY = ("ModuleError", "AskAgain", "self.warn", "illegal", "shutdown")


@cache
def calls_of(path):
    """Each call in its code: what is called, and what stands in the brackets."""
    calls = [node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Call)]
    return [(ast.unparse(call.func), call.args) for call in calls]


def sentences_of(path):
    """What stands first in each call that says something."""
    return [args[0] for name, args in calls_of(path) if name in SAY and args]


def meanings_of(path):
    """What each input of a module means, as its declaration says."""
    inputs = [args for name, args in calls_of(path) if name == "Input" and len(args) == 3]
    return {ast.literal_eval(args[2]) for args in inputs}


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.stem)
def test_every_sentence_of_a_shipped_module_has_its_spanish_with_the_same_gaps(path):
    sentences = {node.value for node in sentences_of(path) if isinstance(node, ast.Constant)} | meanings_of(path)
    catalogue = path.with_name(f"{path.stem}.es.toml")
    translations, faults = read(catalogue.read_text() if catalogue.exists() else "", str(catalogue))
    assert faults == ()
    assert set(translations) == sentences


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.stem)
def test_no_shipped_module_puts_values_into_its_sentences_itself(path):
    assert not any(isinstance(node, ast.JoinedStr) for node in sentences_of(path))


def test_shipped_modules_say_something():
    assert sum(isinstance(node, ast.Constant) for path in MODULES for node in sentences_of(path)) >= 7
