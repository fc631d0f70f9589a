"""An application written as text is read back as the same one, whatever it is (R-D14)."""

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.files.models import TYPES, applications, onikons, words

from onika.files import appl
from onika.files.al.reading import read
from onika.files.al.writing import write
from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank

tags = st.sampled_from(["again", "meet", "END", "a#1", '"', "{", "back\\"]) | words
JUNK = ["END", "END IF", "DO", "TO x", "WHILE", "IF", "}", "{", '"', "(", "#1", "BEGIN", "WHERE", "END WHERE", "\x00"]


@st.composite
def tagged(draw: st.DrawFn) -> Application:
    """Few tags at many icons: loops within loops, crossing ones, lonely ends."""
    onikon = draw(onikons.filter(lambda one: not one.type.endswith("object")))
    few = st.none() | st.sampled_from(["a", "b", "c"])
    made = st.builds(
        lambda tag, test: Icon(onikon, while_tag=tag, while_test=tag is not None and test), few, st.booleans()
    )
    return Application("a", False, (AppFlow(tuple(draw(st.lists(made, max_size=9)))),))


def dictionary_of(application: Application, kept: Any) -> Any:
    """A dictionary of some of its icons: with other values, or under a name that means something else."""
    found = {
        step.onikon.name: step.onikon for flow in application.flows for step in flow.steps if isinstance(step, Icon)
    }
    return {name: onikon for name, onikon in found.items() if kept(name)}.get


@given(application=applications | tagged(), data=st.data())
@settings(max_examples=200, deadline=None)
def test_any_application_is_read_back_as_the_same_and_its_file_has_the_same_bytes(
    application: Application, data: st.DataObject
) -> None:
    dictionary = dictionary_of(application, lambda _: data.draw(st.booleans()))
    text = write(application, TYPES, dictionary)
    again, faults = read(text, "a", "a.al", TYPES, dictionary)
    assert [one for one in faults if not one.is_note] == []
    assert again == application
    assert appl.write(again) == appl.write(application)
    assert write(again, TYPES, dictionary) == text
