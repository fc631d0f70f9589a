"""Descriptions of icons in other languages (requirement X11)."""

from onika.desk.environment.state.dictionary import find
from onika.desk.environment.state.model import Model
from onika.model.onikon import Onikon
from onika.words.reason import NOTHING, Reason


def words_of(model: Model, onikon: Onikon) -> dict[str, str]:
    """What a placed icon says in other languages, by their codes: its own words, else those of its dictionary.

    Those of the dictionary count only while it says the same in its own language: a placed icon keeps what it says.
    """
    if onikon.words:
        return dict(onikon.words)
    onikon_file = find(model.dictionaries, onikon.name)
    if onikon_file and onikon_file.value.description == onikon.description:
        return dict(onikon_file.value.words)
    return {}


def for_placing(onikon: Onikon) -> Onikon:
    """An icon of a dictionary as it is placed: so an application that says nothing new stays one of version 1.3."""
    return onikon.as_placed()


def told_again(former: Onikon, description: str) -> tuple[tuple[str, str], ...]:
    """The words of an icon that says something else from now on: they would say what it said before."""
    if " ".join(former.description.split()) == description:
        return former.words
    return ()


def forgotten(former: Onikon, description: str) -> Reason:
    """That words in other languages are gone; nothing: there were none, or they still say the same."""
    if not former.words or told_again(former, description):
        return NOTHING
    return Reason.of("desk.words_forgotten", name=former.name, codes=tuple(code for code, _ in former.words))
