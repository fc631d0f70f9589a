import itertools

import pytest

from onika.link.state import CHANGES, LinkEvent, LinkState, diagram, follow

S, E = LinkState, LinkEvent

EXPECTED = {
    (S.APART, E.OPENED): S.GREETING,
    (S.APART, E.CLOSED): S.ENDED,
    (S.GREETING, E.OPENED): S.GREETING,
    (S.GREETING, E.GREETED): S.LINKED,
    (S.GREETING, E.SILENT): S.APART,
    (S.GREETING, E.CUT): S.APART,
    (S.GREETING, E.REFUSED): S.ENDED,
    (S.GREETING, E.CLOSED): S.ENDED,
    (S.LINKED, E.OPENED): S.GREETING,
    (S.LINKED, E.HEARD): S.LINKED,
    (S.LINKED, E.QUIET): S.SUSPECT,
    (S.LINKED, E.SILENT): S.APART,
    (S.LINKED, E.CUT): S.APART,
    (S.LINKED, E.CLOSED): S.ENDED,
    (S.SUSPECT, E.OPENED): S.GREETING,
    (S.SUSPECT, E.HEARD): S.LINKED,
    (S.SUSPECT, E.SILENT): S.APART,
    (S.SUSPECT, E.CUT): S.APART,
    (S.SUSPECT, E.CLOSED): S.ENDED,
}


@pytest.mark.parametrize(("state", "event"), list(itertools.product(LinkState, LinkEvent)))
def test_every_state_answers_every_event_as_written_or_refuses_it(state, event):
    if (state, event) in EXPECTED:
        assert follow(state, event) is EXPECTED[state, event]
    else:
        with pytest.raises(ValueError, match=f"in state {state.name}, found {event.name}"):
            follow(state, event)


def test_there_is_no_link_without_a_greeting():
    ways = [(state, event) for state, changes in CHANGES.items() for event, new in changes.items() if new is S.LINKED]
    assert set(ways) == {(S.GREETING, E.GREETED), (S.LINKED, E.HEARD), (S.SUSPECT, E.HEARD)}


def test_the_diagram_has_one_arrow_for_each_change():
    text = diagram()
    arrows = [line for line in text.splitlines() if ": " in line]
    assert text.startswith("stateDiagram-v2\n")
    assert len(arrows) == len(EXPECTED)
    assert "    suspect --> linked: a packet came" in arrows
