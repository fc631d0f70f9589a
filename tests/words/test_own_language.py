import pytest

from onika.words.own_language import VARIABLE, own_language


@pytest.mark.parametrize(("wanted", "spoken"), [("es", "es"), ("en", "en"), ("tlh", "en"), ("", "en")])
def test_the_variable_names_the_language_and_else_it_is_english(monkeypatch, wanted, spoken):  # R-G03
    monkeypatch.setenv(VARIABLE, wanted)
    assert own_language() == spoken
