import pytest

from onika.cli.lines.consent import agrees


@pytest.mark.parametrize(("typed", "is_agreed"), [("y", True), ("Sí", True), ("", False), ("no", False)])
def test_only_who_says_yes_agrees(typed, is_agreed, monkeypatch):
    monkeypatch.setattr("builtins.input", lambda _question: typed)
    assert agrees("well?") is is_agreed
