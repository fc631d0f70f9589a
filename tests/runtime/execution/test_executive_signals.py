"""What the signals of a task lead to: every row of Table 9."""

import pytest

from kit.labs.module_source import cycle, module
from kit.runtime.executive_rig import HOME, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news

MS = 1_000_000


# Signals


def test_a_trigger_that_finishes_goes_off_and_says_where_to_go():  # R-A07, R-A08
    rig = rig_of(cycle("return finish(flow=2, loop=True)", trigger=True)).switch(on=["one"]).run(50 * MS)
    assert rig.news_of(news.Finished) == [news.Finished(HOME, "one", 2, True, 0)]
    assert rig.task("one").state is State.OFF


@pytest.mark.parametrize("flow", ["np.int64(2)", "np.uint8(2)"])
def test_numbers_of_numpy_in_a_signal_travel(flow):
    source = "import numpy as np\n" + cycle(f"return finish(flow={flow}, loop=np.bool_(True))", trigger=True)
    finished = rig_of(source).switch(on=["one"]).run(0).last(news.Finished)
    assert news.decode(news.encode(finished)) == news.Finished(HOME, "one", 2, True, 0)
    assert (type(finished.flow), type(finished.loop)) == (int, bool)


@pytest.mark.parametrize(
    ("flags", "returned", "text"),
    [
        ({}, "finish()", "TypeError: only a trigger finishes a job"),
        ({"trigger": True}, "True", "TypeError: expected a signal or None from cycle, found True"),
        ({"trigger": True}, "Signal(SignalKind.FINISH, flow=0.5)", "TypeError: 'float' object"),
    ],
)
def test_what_a_task_may_not_return_is_an_error(flags, returned, text):  # R-A08
    rig = rig_of(cycle(f"return {returned}", **flags)).switch(on=["one"]).run(0)
    assert rig.last(news.Failed).text.startswith(text)
    assert rig.news_of(news.Finished) == []


def test_a_task_may_switch_itself_off():  # R-A08
    rig = rig_of(cycle("return off()", passive=True)).switch(on=["one"]).run(50 * MS)
    assert rig.last(news.Changed) == news.Changed(HOME, "one", "OFF", 0, "OFF")


@pytest.mark.parametrize(
    ("returned", "kind", "number", "text"),
    [
        ("illegal('door open')", "ILLEGAL", 0, "door open"),
        ("shutdown('power')", "SHUTDOWN", 0, "power"),
        ("legal()", "LEGAL", 0, ""),
        ("user_signal(40)", "USER", 40, ""),
    ],
)
def test_other_signals_are_passed_on_and_the_task_stays_on(returned, kind, number, text):  # R-A07
    rig = rig_of(cycle(f"return {returned}")).switch(on=["one"]).run(0)
    assert rig.news_of(news.Signalled) == [news.Signalled(HOME, "one", kind, number, text, 0)]
    assert rig.task("one").state is State.ON


@pytest.mark.parametrize("entry", ["init", "on", "cycle", "off", "kill", "clear"])
def test_a_warning_of_every_entry_point_is_passed_on(entry):  # R-A07
    arguments = ", inputs" if entry == "on" else ""
    body = f"    def {entry}(self{arguments}):\n        self.warn('mind')"
    if entry == "clear":
        body += "\n    def cycle(self):\n        raise ValueError"
    rig = rig_of(module(body)).switch(on=["one"]).run(0).do(command.Clear(HOME, "one"))
    rig.switch(off=["one"]).do(command.Kill(HOME, "one"))
    assert [event.text for event in rig.news_of(news.Warned)] == ["mind"]


# Table 9: every signal, once, twice, and when the task is off already


TABLE_9 = {
    "off()": (news.Changed, State.OFF),
    "finish(flow=1, loop=True)": (news.Finished, State.OFF),
    "finish()": (news.Finished, State.OFF),
    "raise_()": (news.Failed, State.ERROR),
    "warn()": (news.Warned, State.ON),
    "shutdown('power')": (news.Signalled, State.ON),
    "illegal('door')": (news.Signalled, State.ON),
    "legal()": (news.Signalled, State.ON),
    "user_signal(17)": (news.Signalled, State.ON),
    "user_signal(20)": (news.Signalled, State.ON),
}
SAYS = "    def cycle(self):\n        def raise_():\n            raise ValueError('x')\n        def warn():\n"
SAYS += "            self.warn('mind')\n        return {said}"


def said_rig(signal, launches=1):
    """A trigger, not passive where it finishes: both may not be."""
    rig = rig_of(module(SAYS.format(said=signal), trigger=signal.startswith("finish")))
    for run in range(launches):
        rig.switch(on=[command.Launch("one", activation=run)])
    return rig


@pytest.mark.parametrize("signal", TABLE_9)
def test_the_unit_answers_each_signal_as_table_9_says(signal):  # R-A07
    kind, state = TABLE_9[signal]
    rig = said_rig(signal).run(0)
    events = [event for _, event in rig.news if isinstance(event, kind) and getattr(event, "state", "OFF") == "OFF"]
    assert len(events) == 1
    assert rig.task("one").state is state
    if kind is news.Finished:
        assert (events[0].flow, events[0].loop) == ((1, True) if "flow" in signal else (0, False))
    if signal.startswith("user"):
        assert (events[0].kind, events[0].number) == ("USER", int(signal[12:14]))


@pytest.mark.parametrize("signal", TABLE_9)
def test_a_signal_that_comes_twice_is_told_twice_only_where_the_task_is_still_on(signal):  # R-A07
    kind, state = TABLE_9[signal]
    rig = said_rig(signal).run(10 * MS)
    events = [event for _, event in rig.news if isinstance(event, kind) and getattr(event, "state", "OFF") == "OFF"]
    assert len(events) == (2 if state is State.ON else 1)


@pytest.mark.parametrize("signal", TABLE_9)
def test_a_signal_of_each_activation_is_told_apart(signal):  # R-A07
    kind, _ = TABLE_9[signal]
    rig = said_rig(signal).run(0).switch(off=["one"]).do(command.Clear(HOME, "one"))
    rig.switch(on=[command.Launch("one", activation=9)]).run(rig.now)
    numbers = {event.activation for _, event in rig.news if isinstance(event, kind) and hasattr(event, "activation")}
    assert numbers == ({0, 9} if kind is not news.Warned else set())


@pytest.mark.parametrize("signal", TABLE_9)
def test_a_signal_that_comes_late_is_no_word_of_a_task_that_is_off(signal):  # R-A07, R-A08
    """A synchronous task whose event arrives after it was turned off: nothing is called, nothing told."""
    body = SAYS.format(said=signal).replace("def cycle", "def sync") + PIPE
    rig = rig_of(module(body, trigger=signal.startswith("finish")), kind="synchronous").switch(on=["one"])
    rig.switch(off=["one"])
    count = len(rig.news)
    assert rig.executive.event((HOME, "one"), 0) == []
    assert (len(rig.news), rig.task("one").state) == (count, State.OFF)
    rig.do(command.Kill(HOME, "one"))


@pytest.mark.parametrize("signal", TABLE_9)
def test_a_signal_in_the_cycle_in_which_everything_is_stopped_is_told_first(signal):  # R-A07, law 27
    kind, _ = TABLE_9[signal]
    rig = said_rig(signal)
    rig._react = lambda event: [command.Stop()] if isinstance(event, news.Cycled) else []
    rig.run(50 * MS)
    assert any(isinstance(event, kind) for _, event in rig.news)
    assert rig.task("one").state in (State.OFF, State.ERROR)
    assert rig.task("one").counters.cycles <= 1


PIPE = """
    def fileno(self):
        return self._in
    def init(self):
        import os
        self._in, self._out = os.pipe()
    def kill(self):
        import os
        os.close(self._in)
        os.close(self._out)
"""
