import pytest

from onika.cli.library.consent import agrees
from onika.words.reason import Reason


@pytest.mark.parametrize(("typed", "is_agreed"), [("y", True), ("Sí", True), ("", False), ("no", False)])
def test_only_who_says_yes_agrees(typed, is_agreed, monkeypatch):
    monkeypatch.setattr("builtins.input", lambda _question: typed)
    assert agrees(Reason.of("cli.library_agree_question")) is is_agreed
