import pytest
from tests.files.models import TYPES

from onika.files.al.verb import preposition, verb
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax

MORE = (
    "Cartesian job",
    "Polynomial path job",
    "Relative job",
    "Guarded job",
    "Pause job",
    "Force job",
    "Force application",
)
SYNTAX = Syntax((*TYPES.types, *(IconType(name, 0, 0) for name in MORE)), ())


def named(name: str, kind: str) -> Onikon:
    return Onikon(name, kind, "", (), blank())


@pytest.mark.parametrize(
    ("name", "kind", "word"),
    [
        ("jmoveC", "Joint job", "DRIVE"),
        ("cmoveC", "Cartesian job", "MOVE"),
        ("follow", "Polynomial path job", "MOVE"),
        ("on", "Relative job", "MOVE"),
        ("until", "Guarded job", "MOVE"),
        ("wait", "Pause job", "PAUSE"),
        ("opengripC", "Complete job", "OPEN"),
        ("Close_it", "Complete job", "CLOSE"),
        ("openpress", "Force job", "DO"),
        ("lamp", "Complete job", "DO"),
        ("assemble", "Complete application", "RUN"),
        ("press", "Force application", "RUN"),
        ("opens", "Complete application", "RUN"),
        ("unknown", "Colour job", "DO"),
        ("noop", "Complete NOP", "NOP"),
        ("home", "Joint object", "DO"),
    ],
)
def test_the_verb_follows_from_the_type_and_for_hands_from_the_name(name: str, kind: str, word: str) -> None:
    assert verb(named(name, kind), SYNTAX) == word  # R-D14, §4.4.2 to §4.4.6


@pytest.mark.parametrize(
    ("kind", "is_first", "word"),
    [
        ("Joint object", True, "TO"),
        ("Polynomial path object", True, "USING"),
        ("Pause object", True, "WITH"),
        ("Joint object", False, "WITH"),
    ],
)
def test_a_target_is_called_as_in_al(kind: str, is_first: bool, word: str) -> None:
    assert preposition(named("x", kind), is_first) == word
