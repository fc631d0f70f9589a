"""The word of AL by which an icon is called, and the one before its target (dissertation §4.4.2 to §4.4.6)."""

from onika.model.onikon import Onikon
from onika.model.syntax import Syntax, has_word

VERBS = ("DRIVE", "MOVE", "OPEN", "CLOSE", "PAUSE", "DO", "RUN", "NOP")
"""What an action begins with."""

PREPOSITIONS = ("TO", "USING", "WITH")
"""What a target begins with; a reader takes them for the same."""

HANDS = ("OPEN", "CLOSE")
"""The verbs behind which the word HAND stands."""

ANY = "DO"
"""The verb that fits every action."""

_BY_TYPE = (
    ("joint", "DRIVE"),
    ("cartesian", "MOVE"),
    ("relative", "MOVE"),
    ("guarded", "MOVE"),
    ("path", "MOVE"),
    ("pause", "PAUSE"),
)
_BY_NAME = (("open", "OPEN"), ("close", "CLOSE"))


def verb(onikon: Onikon, syntax: Syntax) -> str:
    """The verb of an action, by the words of its type; complete jobs called open… and close… move the hand."""
    kind = syntax.acting(onikon.type)
    if kind is None or not kind.is_action:
        return ANY
    if kind.is_noop:
        return "NOP"
    if kind.is_application:
        return "RUN"
    by_name = (word for start, word in _BY_NAME if kind.is_complete and onikon.name.lower().startswith(start))
    by_type = (word for of, word in _BY_TYPE if has_word(onikon.type, of))
    return (*by_type, *by_name, ANY)[0]


def preposition(target: Onikon, is_first: bool) -> str:
    """The word before a target; `is_first`: of those of its action."""
    if not is_first or has_word(target.type, "pause"):
        return "WITH"
    return "USING" if has_word(target.type, "path") else "TO"
