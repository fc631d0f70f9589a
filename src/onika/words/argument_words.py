"""The words of argparse in the language of this process: it asks for each by its English, and is answered from here."""

import argparse

from onika.words.catalogue import sentence
from onika.words.own_language import own_language
from onika.words.sentence import LANGUAGES

_KEYS = (
    "cli.arg_usage",
    "cli.arg_positionals",
    "cli.arg_options",
    "cli.arg_help",
    "cli.arg_of",
    "cli.arg_error",
    "cli.arg_unknown_parser",
    "cli.arg_unrecognized",
    "cli.arg_not_with",
    "cli.arg_explicit",
    "cli.arg_required",
    "cli.arg_one_required",
    "cli.arg_one_value",
    "cli.arg_one_at_most",
    "cli.arg_one_at_least",
    "cli.arg_count_one",
    "cli.arg_count",
    "cli.arg_ambiguous",
    "cli.arg_invalid",
    "cli.arg_choice",
)
"""What it may say of a command line; of our parsers themselves it says it in English."""


def translate() -> None:
    """Have every parser speak the language of this process from now on, instead of asking `gettext`."""
    vars(argparse).update(_=_translation, ngettext=_translation_of_count)


def _translation(message: str) -> str:
    if own_language() == LANGUAGES[0]:
        return message
    keys = {sentence(LANGUAGES[0], key): key for key in _KEYS}
    if message in keys:
        return sentence(own_language(), keys[message])
    return message


def _translation_of_count(one: str, several: str, count: int) -> str:
    return _translation(one if count == 1 else several)
