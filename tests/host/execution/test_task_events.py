"""Table 9 without an application: what sessions hear of every signal, once for each time it is said."""

import pytest
from msgspec import structs

from kit.runtime.live_edits import LiveEdits
from onika.host.execution.task_events import by_hand, in_a_run, question_of
from onika.runtime import news
from onika.runtime.user_input import AskedItem
from onika.wire import event, live
from onika.words.reason import NOTHING, Reason

SPEAKER = """
from onika.module import Module, ModuleError, OutVar, finish, illegal, legal, off, shutdown, user_signal

class Speaker(Module):
    trigger = True
    SAID = OutVar("double", "-", "how often it spoke")

    def init(self):
        self._say = []

    def set(self, name, value):
        self._say = [value] * int(name)

    def cycle(self):
        if not self._say:
            return None
        self.SAID = self.SAID + 1.0
        word = self._say.pop()
        if word == "ERROR":
            raise ModuleError("too hot")
        if word == "WARNING":
            self.warn("warm")
            return None
        return {
            "OFF": off, "FINISH": lambda: finish(flow=2), "ILLEGAL": lambda: illegal("hand in the gate"),
            "LEGAL": legal, "SHUTDOWN": lambda: shutdown("power"), "USER": lambda: user_signal(19),
        }[word]()
"""


@pytest.fixture
def speaker():
    hand = LiveEdits()
    hand.task("speaker", SPEAKER)
    hand.change(spawn=["speaker"], on=["speaker"])
    hand.let_pass(0.1)
    hand.asker.server.events.clear()
    return hand


def say(hand, word, times):
    hand.asker.ask(live.Set("s0", "speaker", str(times), word))
    hand.let_pass(0.5)


def summaries(hand):
    """What sessions are told, without times."""
    return [
        (
            type(message).__name__,
            str(
                getattr(
                    message, "state", getattr(message, "kind", getattr(message, "text", getattr(message, "cause", "")))
                )
            ),
        )
        for message in hand.asker.server.events
    ]


ENDS = {
    "OFF": [("TaskState", "OFF")],
    "FINISH": [("Signalled", "FINISH"), ("TaskState", "OFF")],
    "ERROR": [("Failed", "cycle: ModuleError: too hot"), ("TaskState", "ERROR")],
}
GOES_ON = {
    "WARNING": [("Warned", "warm")],
    "ILLEGAL": [("Signalled", "ILLEGAL")],
    "LEGAL": [("Signalled", "LEGAL")],
    "SHUTDOWN": [("Signalled", "SHUTDOWN")],
    "USER": [("Signalled", "USER")],
}


@pytest.mark.parametrize("times", [1, 2])
@pytest.mark.parametrize("word", GOES_ON)
def test_a_signal_that_ends_nothing_is_told_as_often_as_it_is_said(speaker, word, times):  # R-A07, Table 9
    say(speaker, word, times)
    assert summaries(speaker) == GOES_ON[word] * times
    assert speaker.states == {"speaker": "ON"}


@pytest.mark.parametrize("times", [1, 2])
@pytest.mark.parametrize("word", ENDS)
def test_a_signal_that_ends_a_task_is_told_once(speaker, word, times):  # R-A07, Table 9
    say(speaker, word, times)
    assert summaries(speaker) == ENDS[word]
    assert speaker.states == {"speaker": "ERROR" if word == "ERROR" else "OFF"}


def test_a_finish_tells_its_flow_and_a_user_signal_its_number(speaker):  # R-A07, reading 19
    say(speaker, "USER", 1)
    say(speaker, "FINISH", 1)
    assert [message.number for message in speaker.asker.of(event.Signalled)] == [19, 2]


@pytest.mark.parametrize("word", [*GOES_ON, *ENDS])
def test_a_word_of_a_task_that_is_gone_is_told_to_nobody(speaker, word):  # R-A07
    subsystems = speaker.asker.program.subsystems
    late = {
        "OFF": news.Changed("s0", "speaker", "OFF", 1, "OFF"),
        "FINISH": news.Finished("s0", "speaker", 0, False, 1),
        "ERROR": news.Failed("s0", "speaker", "cycle", Reason.plain("too hot"), "", 0, "", 1),
        "WARNING": news.Warned("s0", "speaker", Reason.plain("warm"), 1),
    }.get(word, news.Signalled("s0", "speaker", word, 0, NOTHING, 1))
    speaker.change(kill=["speaker"])
    speaker.asker.server.events.clear()
    subsystems.hear("rt0", late, 1)
    assert speaker.asker.server.events == []
    assert speaker.states == {}


STEPPED = news.Stepped("s0", "arm", "TAU", "N m", 1, 40.0, 10.0, 10.0, 8, 2_000_000_000)


def test_a_step_at_a_live_change_is_told_with_its_numbers():  # R-X04
    message = by_hand(STEPPED, 2.0)
    assert message == event.Stepped("s0", "arm", "TAU", "N m", 1, 40.0, 10.0, 10.0, 8, 2.0)
    assert message.is_too_far
    assert not by_hand(structs.replace(STEPPED, step=10.0), 2.0).is_too_far
    assert not by_hand(structs.replace(STEPPED, limit=0.0), 2.0).is_too_far


def test_a_run_tells_only_steps_that_are_too_far():  # R-X04
    assert in_a_run(STEPPED, 2.0) == by_hand(STEPPED, 2.0)
    assert in_a_run(structs.replace(STEPPED, step=10.0), 2.0) is None


def test_a_run_tells_failures_and_warnings_and_leaves_signals_to_the_engine():  # R-A08, R-A18, Table 9
    failed = news.Failed("left", "arm", "cycle", Reason.plain("no"), "arm.py", 7, "trace", 1, values={"X": 1})
    messages = in_a_run(failed, 0.125)
    assert (str(messages.text), messages.line, messages.at_s, messages.values) == ("cycle: no", 7, 0.125, {"X": 1})
    assert in_a_run(news.Warned("left", "arm", Reason.plain("hot"), 1), 0.0) == event.Warned(
        "left", "arm", Reason.plain("hot"), 0.0
    )
    assert in_a_run(news.Finished("left", "arm", 0, False, 1), 0.0) is None
    assert in_a_run(news.Signalled("left", "arm", "LEGAL", 0, NOTHING, 1), 0.0) is None


def test_a_task_is_turned_on_again_after_each_end(speaker):  # R-A05, R-A09
    say(speaker, "FINISH", 1)
    assert speaker.change(on=["speaker"]) == ""
    say(speaker, "ERROR", 1)
    assert "on: " in speaker.change(on=["speaker"])
    assert speaker.clear("speaker") == ""
    assert speaker.change(on=["speaker"]) == ""


def test_where_a_module_failed_is_told_with_its_values(speaker):  # R-A18
    say(speaker, "ERROR", 1)
    failed = speaker.asker.of(event.Failed)[0]
    assert (failed.path, failed.line) == (
        "speaker.py",
        SPEAKER.splitlines().index('            raise ModuleError("too hot")') + 1,
    )
    assert failed.values == {"SAID": 1.0}
    assert "too hot" in failed.traceback


def test_what_a_task_asks_for_is_told_item_by_item():  # R-A10
    item = AskedItem("goal", "double", 1, "m", "where to", None, (-9.0,), (9.0,))
    question = question_of(news.Asked("s0", "servo", Reason.plain("too far"), (item,), 5), 0.5)
    assert (question.task, str(question.reason), question.at_s) == ("servo", "too far", 0.5)
    assert [(item.name, item.low, item.high) for item in question.items] == [("goal", (-9.0,), (9.0,))]


def test_a_change_by_command_is_told_by_its_state_alone():
    assert by_hand(news.Changed("s0", "servo", "OFF", 5), 0.5) is None
    assert by_hand(news.Initialised("s0", "servo"), 0.5) is None
