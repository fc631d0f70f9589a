import contextlib
import io
from typing import ClassVar

import pytest
from rich.console import Console

from onika.cli import live_display as room
from onika.cli.live_display import LiveDisplay
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.outcome import Outcome
from onika.store.site import open_site
from onika.wire import event
from onika.wire.steer import Position
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

PREPARED = prepare_run("two_arms", open_site([], {}, None))
ITEMS = (
    event.Item("level", "double", 2, "m", "how high", None, None, None),
    event.Item("name", "string", 1, "-", "of whom", None, None, None),
)
RESULT = event.Result(True, NOTHING, 4, 4, 5.0, 5.0, {}, (), "")


class Answers:
    """A terminal at which these lines are typed; None is a turn without one."""

    prompts: ClassVar = []

    def __init__(self, *answers):
        self._answers = list(answers)
        self.prompts.clear()

    def line(self, prompt, timeout_s):
        self.prompts.append(prompt)
        if not self._answers:
            raise EOFError
        return self._answers.pop(0)


@pytest.fixture
def screen(monkeypatch):
    """What is shown, as text."""
    shown = io.StringIO()
    monkeypatch.setattr(
        room, "Console", lambda **given: Console(file=shown, force_terminal=True, width=200, color_system=None, **given)
    )
    return shown


def test_actions_scroll_by_and_the_panel_shows_what_goes_on(screen):  # R-E11
    with LiveDisplay() as live:
        live.begins(PREPARED, 4711)
        for happening in (
            event.TaskState("flow0", "jtraj", "ON", 0.0),
            event.TaskState("flow0", "pd", "KILLED", 0.0),
            event.Began(0, 0, 2, "jmoveC aside", 0.0),
            event.Done(0, 0, 2.0),
            event.Warned("flow0", "jtraj", Reason.plain("too fast"), 2.0),
            event.Failed("flow0", "jtraj", Reason.plain("cycle: no"), "jtraj.py", 7, "", 2.0),
        ):
            live.happens(happening)
        live._screen.refresh()
    text = screen.getvalue()
    assert "0.00 s  flow0  1/2  jmoveC aside" in text
    assert "note: jtraj: too fast" in text
    assert "ERROR flow0/jtraj: cycle: no (jtraj.py:7)" in text
    assert "○ ready" in text
    assert "▶ jtraj" in text
    assert "pd  " not in text


def test_before_the_run_it_says_that_it_prepares(screen):
    with LiveDisplay():
        pass
    assert "preparing" in screen.getvalue()


def test_each_value_is_asked_for_with_what_it_means_and_the_answers_are_joined(screen, monkeypatch):  # R-A10
    monkeypatch.setattr(room, "Terminal", lambda complete: contextlib.nullcontext(Answers("0.5 0.75", None, "me")))
    with LiveDisplay() as live:
        assert live.answer(event.Asked("flow0", "gauge", Reason.plain("too low"), ITEMS, 0.0)) == "0.5 0.75 me"
    assert "too low" in screen.getvalue()
    assert Answers.prompts == [
        "gauge asks for level (2 values), how high, in m: ",
        "gauge asks for name, of whom: ",
        "gauge asks for name, of whom: ",
    ]


def test_what_was_asked_and_answered_stays_above_the_panel(screen, monkeypatch):  # R-A10
    monkeypatch.setattr(room, "Terminal", lambda complete: contextlib.nullcontext(Answers("0.5 0.75", "me")))
    with LiveDisplay() as live:
        live.begins(PREPARED, 4711)
        live._screen.refresh()
        live.answer(event.Asked("flow0", "gauge", NOTHING, ITEMS, 0.0))
        position = screen.tell()
        live._screen.refresh()
        assert "\x1b[1A" not in screen.getvalue()[position:]  # no row above is touched


def test_at_the_end_of_the_input_nobody_answers(screen, monkeypatch):  # R-A10
    monkeypatch.setattr(room, "Terminal", lambda complete: contextlib.nullcontext(Answers()))
    with LiveDisplay() as live:
        assert live.answer(event.Asked("flow0", "gauge", NOTHING, ITEMS, 0.0)) is None


def test_signs_that_mean_colours_elsewhere_are_shown_as_they_are(screen):
    with LiveDisplay() as live:
        live.happens(event.Warned("flow0", "jtraj", Reason.plain("[red]danger[/red]"), 0.0))
    assert "[red]danger[/red]" in screen.getvalue()


def test_the_summary_comes_last(screen):  # R-E14
    live = LiveDisplay()
    with live:
        live.begins(PREPARED, 4711)
    live.ended(Outcome("two_arms", result=RESULT), Reason.plain("picture: out.png"))
    verdict, drawn = screen.getvalue().rstrip().splitlines()[-2:]
    assert verdict.endswith("two_arms: completed, 4 of 4 actions, 5.00 s, in 5.00 s of wall time")
    assert drawn == "picture: out.png"


class Keys:
    """A keyboard on which these keys are pressed, one after another."""

    is_there = True

    def __init__(self, *keys):
        self.keys = list(keys)

    def pressed(self):
        return [self.keys.pop(0)] if self.keys else []


def test_keys_become_lines_of_steering(screen, monkeypatch):  # R-E07
    with LiveDisplay() as live:
        live.begins(PREPARED, 4711)
        monkeypatch.setattr(live, "_keyboard", Keys("p", "1", "c"))
        assert live.can_steer
        assert [live.wishes() for _ in range(3)] == [["pause"], [], ["continue flow1"]]
        monkeypatch.undo()


def test_a_line_is_shown_with_what_came_of_it(screen):  # R-E07, R-X03
    with LiveDisplay() as live:
        live.begins(PREPARED, 4711)
        live.steered("pass", (Fault(Place("line"), Reason.plain("expected one, found two"), Reason.plain("no")),), ())
        live.steered(
            "skip 9", (Fault(Place("s", 2), Reason.plain("expected three, found four"), Reason.plain("no")),), ()
        )
        live.steered("who", (), (Position("flow0", "paused", 0),))
    text = screen.getvalue()
    assert "> pass" in text
    assert "expected one, found two; instead: no" in text
    assert "line: expected" not in text
    assert "s:2: expected three" in text
    assert "flow0  paused  1/2 jmoveC aside" in text


def test_it_looks_where_the_flows_are_when_they_have_moved(screen, monkeypatch):  # R-E11
    now = [100.0]
    monkeypatch.setattr(room, "monotonic", lambda: now[0])
    with LiveDisplay() as live:
        live.begins(PREPARED, 4711)
        assert not live.looks()
        live.happens(event.Moved("flow0", "running", 0, 0.0))
        assert live.looks()
        live.happens(event.Began(0, 0, 2, "jmoveC aside", 0.0))
        assert not live.looks()
        now[0] += 1.0
        assert live.looks()
        live.placed((Position("flow0", "running", 0, loops=("outer",)),))
        live._screen.refresh()
    assert "↺ outer" in screen.getvalue()


def test_a_question_waits_until_the_program_has_the_terminal_again(screen, monkeypatch):  # R-E07
    turns = iter([True, True, False])
    monkeypatch.setattr(room, "Terminal", lambda complete: contextlib.nullcontext(Answers("1", "me")))
    monkeypatch.setattr(room, "sleep", lambda s: None)
    monkeypatch.setattr(room.Keyboard, "is_in_background", property(lambda _: next(turns)))
    with LiveDisplay() as live:
        assert live.answer(event.Asked("flow0", "gauge", NOTHING, ITEMS, 0.0)) == "1 me"
    assert next(turns, None) is None
