"""Catalogues are parted by domain; what is in all of them is tried in tests/contract/test_texts.py."""

import pytest

from onika.words.catalogue import domains, sentence, sentences
from onika.words.sentence import LANGUAGES


def test_a_sentence_is_known_by_its_key():
    assert sentence("en", "cli.language_option").startswith("the language")
    assert sentence("es", "cli.language_option").startswith("el idioma")


@pytest.mark.parametrize(
    "key", ["cli.there_is_no_such", "nowhere.at_all", "cli", "", "/etc/passwd.x", "../cli.language_option"]
)
def test_an_unknown_key_is_refused(key):
    with pytest.raises(KeyError):
        sentence("en", key)


def test_every_language_has_the_same_domains():
    assert len({domains(language) for language in LANGUAGES}) == 1 and sentences("es", domains("es")[0])
