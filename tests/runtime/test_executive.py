"""Commands in every state, signals, errors and figures of the tasks on one processing unit.

That it runs what is due in the right order is proved beside the reference, in `test_reference.py`.
"""

import pytest

from onika.model.lifecycle import State
from onika.ring.device import Drive
from onika.runtime import command, news
from onika.testing.rig import HOME, Rig
from onika.testing.worlds import MassWorld

MS = 1_000_000
HEAD = """
import sys
from onika.model.signal import Signal, SignalKind
from onika.module import *
from onika.module import AskAgain, Device, InBoth, InConst, InVar, Input, Local, Module, ModuleError, OutVar
"""


def module(body="    pass", **flags):
    """The source of a module with these flags and this body."""
    lines = "\n".join(f"    {name} = {value}" for name, value in flags.items())
    return f"{HEAD}\nclass One(Module):\n{lines}\n{body}\n"


def cycle(line, **flags):
    return module(f"    def cycle(self):\n        {line}", **flags)


def rig_of(source, **given):
    return Rig().spawn("one", source, **given)


def last(rig, kind):
    return rig.heard(kind)[-1]


COUNTER = module("    N = OutVar('int')\n    def cycle(self):\n        self.N += 1")

# Spawning


def test_a_task_is_off_after_it_was_spawned():  # R-A05
    rig = rig_of(module())
    assert rig.heard(news.Initialised) == [news.Initialised(HOME, "one")]
    assert rig.task("one").state is State.OFF


@pytest.mark.parametrize(
    ("source", "given", "reason"),
    [
        ("class :", {}, "one.py:1: expected Python"),
        (module("    G = Local('int', '-', 'gain')"), {}, "expected a LOCAL line G int (gain), found none"),
        (module("    def __init__(self, x):\n        pass"), {}, "TypeError"),
        (module("    def __init__(self):\n        sys.exit(1)"), {}, "SystemExit: 1"),
        (module(), {"frequency": -5.0}, "expected a rate above 0 Hz"),
    ],
)
def test_a_task_that_cannot_live_is_refused_with_the_reason(source, given, reason):  # R-B07
    rig = rig_of(source, **given)
    assert reason in last(rig, news.Refused).reason
    assert rig.executive.tasks == {}


def test_a_second_task_of_one_name_is_refused():  # R-A06
    rig = rig_of(module()).spawn("one", module())
    assert last(rig, news.Refused).reason == "a task of this name lives here already"


def test_one_module_serves_many_tasks_that_share_nothing():  # R-A01, law 14
    source = HEAD + (
        "seen = []\nclass One(Module):\n    N = OutVar('int')\n"
        "    def cycle(self):\n        seen.append(1)\n        self.N = len(seen)\n"
    )
    rig = Rig().spawn("a", source, aliases={"N": "A"}).spawn("b", source, aliases={"N": "B"}, frequency=50.0)
    rig.switch(on=["a", "b"]).run(40 * MS)
    assert (rig["A"], rig["B"]) == (5, 3)


def test_an_init_that_raises_is_an_error_and_clear_initialises_anew():  # R-A05
    source = module(
        "    N = OutVar('int')\n    tried = []\n    def init(self):\n        self.tried.append(1)\n"
        "        if len(self.tried) == 1:\n            raise ModuleError('not yet')"
    )
    rig = rig_of(source)
    assert (last(rig, news.Failed).entry, rig.task("one").state) == ("init", State.ERROR)
    rig.do(command.Clear(HOME, "one"))
    assert rig.heard(news.Initialised) == [news.Initialised(HOME, "one")]
    assert rig.task("one").module.tried == [1, 1]


# Commands that a state does not allow: refused, and nothing has changed


def in_state(state):
    asks = module("    x = Input('int')\n    def cycle(self):\n        raise ValueError('planted')")
    rig = Rig().spawn("one", asks)
    if state is State.ASKING:
        rig.switch(on=["one"])
    if state in (State.ON, State.ERROR):
        rig.switch(on=[command.Launch("one", "1")])
    if state is State.ERROR:
        rig.run(0)
    if state is State.KILLED:
        rig.do(command.Kill(HOME, "one"))
    return rig


def state_of(rig):
    task = rig.executive.tasks.get((HOME, "one"))
    return task.state if task else State.KILLED


ON = command.Switch(HOME, (), (), (command.Launch("one", "1"),))
OFF = command.Switch(HOME, ("one",), (), ())
COMMANDS = {
    "on": (ON, {State.OFF: State.ON}),
    "off": (OFF, {State.ON: State.OFF, State.ASKING: State.OFF}),
    "answer": (command.Answer(HOME, "one", "1"), {State.ASKING: State.ON}),
    "clear": (command.Clear(HOME, "one"), {State.ERROR: State.OFF}),
    "kill": (command.Kill(HOME, "one"), dict.fromkeys(State, State.KILLED)),
}


@pytest.mark.parametrize("state", [State.OFF, State.ASKING, State.ON, State.ERROR, State.KILLED])
@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_does_what_the_table_says_or_is_refused_and_changes_nothing(name, state):  # R-A05, law 11
    order, leads_to = COMMANDS[name]
    rig = in_state(state)
    assert state_of(rig) is state
    heard = len(rig.news)
    rig.do(order)
    assert state_of(rig) is leads_to.get(state, state)
    said = [one for _, one in rig.news[heard:]]
    if state in leads_to:
        assert [type(one) for one in said] == [news.Changed]
        assert said[0].state == leads_to[state].value
    elif name == "off":
        assert said == []  # turning off what is off harms nothing
    else:
        assert [type(one) for one in said] == [news.Refused]
        assert said[0].reason


@pytest.mark.parametrize("order", [command.Get(HOME, "nobody", "x"), command.Set(HOME, "nobody", "x", "1")])
def test_a_task_that_is_not_there_is_refused_by_name(order):
    assert Rig().do(order).heard(news.Refused) == [news.Refused(HOME, "nobody", "get or set", "no such task")]


# Switches


def test_a_switch_turns_off_before_it_turns_on_with_no_cycle_in_between():  # laws 2, 3
    rig = Rig().spawn("a", COUNTER).spawn("b", COUNTER).switch(on=["a"]).run(5 * MS)
    rig.switch(off=["a"], on=["b"])
    told = [(one.task, one.state) for one in rig.heard(news.Changed)]
    assert told == [("a", "ON"), ("a", "OFF"), ("b", "ON")]
    assert rig.run(15 * MS)["N"] == 1 + 2


def test_the_first_cycle_after_on_is_told_once():
    rig = rig_of(COUNTER).switch(on=["one"]).run(30 * MS).switch(off=["one"]).switch(on=["one"]).run(50 * MS)
    assert [one.at_ns for one in rig.heard(news.Cycled)] == [0, 30 * MS]


def test_a_reference_stays_in_force_while_it_is_read_and_a_stale_one_does_not():  # law 3, decision 45
    """cmove, jmove, cmove: the joint reference goes on without a jump; X_REF stood still, so it is not continued."""
    source = module(
        "    REF = OutVar('double')\n    Q = InVar('double')\n    def on(self, inputs):\n"
        "        self.began = self.continues('REF')\n        self.REF += 1.0"
    )
    rig = Rig()
    for task, ref in (("line", "X_REF"), ("joint", "Q_REF")):
        rig.spawn(task, source, aliases={"REF": ref, "Q": ref + "2"})
    began = []
    for off, on, forget in [
        ("", "line", ()),
        ("line", "joint", ("X_REF",)),
        ("joint", "joint", ()),
        ("joint", "line", ()),
    ]:
        rig.switch(off=[off] if off else [], on=[on], forget=forget).run(rig.now + 20 * MS)
        began.append((on, rig.task(on).module.began))
    assert began == [("line", False), ("joint", False), ("joint", True), ("line", False)]
    assert rig["X_REF"] == 2.0  # preloaded all the same


def test_what_another_subsystem_forgets_is_none_of_ours():  # R-A06
    rig = rig_of(COUNTER).switch(on=["one"]).run(0)
    rig.do(command.Switch("other", (), ("N",), ()))
    assert rig.table.ring("N").mark == 0


@pytest.mark.parametrize("rate", [0.0, -1.0, float("nan"), float("inf"), 2e9])
def test_a_rate_that_is_none_is_refused_and_the_old_one_stays(rate):  # R-A04
    rig = rig_of(COUNTER).switch(on=["one"], rates=[("one", rate)])
    assert "expected a rate" in last(rig, news.Refused).reason
    assert rig.run(20 * MS)["N"] == 3


def test_a_rate_given_at_on_holds_from_then_on():  # R-A04
    rig = rig_of(COUNTER).switch(on=[command.Launch("one", "", 200.0)]).run(20 * MS)
    assert rig["N"] == 5
    assert rig.task("one").module.dt == 0.005
    assert rig.switch(rates=[("nobody", 5.0)]).heard(news.Refused)[0].reason == "no such task"


# Kinds of tasks


def test_an_aperiodic_task_runs_once_for_each_on_and_each_set():  # R-A04, law 24
    source = COUNTER + "\n    def set(self, name, value):\n        pass"
    rig = rig_of(source, kind="aperiodic", frequency=None).switch(on=["one"]).run(5000 * MS)
    assert rig["N"] == 1
    for expected in (2, 3):
        assert rig.do(command.Set(HOME, "one", "x", "1")).run(rig.now + 5000 * MS)["N"] == expected
    assert rig.switch(off=["one"], on=["one"]).run(rig.now + 10 * MS)["N"] == 4


def test_a_set_of_an_aperiodic_task_that_is_off_runs_nothing():  # law 24
    source = module(
        "    N = OutVar('int')\n    def cycle(self):\n        self.N += 1\n    def set(self, *_):\n        pass"
    )
    rig = rig_of(source, kind="aperiodic", frequency=None).do(command.Set(HOME, "one", "x", "1")).run(100 * MS)
    assert rig["N"] == 0


def test_a_rate_does_not_make_an_aperiodic_task_run_again():  # R-A04
    rig = rig_of(COUNTER, kind="aperiodic", frequency=None).switch(on=["one"]).run(0)
    assert rig.switch(rates=[("one", 100.0)]).run(100 * MS)["N"] == 1


PIPE = """
    def init(self):
        import os
        self._in, self._out = os.pipe()
    def fileno(self):
        return self._in
    def kill(self):
        import os
        os.close(self._in)
        os.close(self._out)
"""
SYNC = module("    N = OutVar('int')" + PIPE + "    def sync(self):\n        self.N += 1\n        self.warn('heard')")


def test_a_synchronous_task_runs_on_its_event_only():  # R-A04
    rig = rig_of(SYNC, kind="synchronous").switch(on=["one"]).run(200 * MS)
    assert rig["N"] == 0
    heard = rig.executive.event((HOME, "one"), 200 * MS)
    assert rig["N"] == 1
    assert [type(one) for one in heard] == [news.Cycled, news.Warned]


def test_a_synchronous_task_waits_for_its_descriptor_while_it_is_on():  # R-A04
    rig = rig_of(SYNC, kind="synchronous").switch(on=["one"])
    assert list(rig.executive.events().values()) == [(HOME, "one")]
    rig.switch(off=["one"])
    assert rig.executive.events() == {}


def test_a_synchronous_module_that_names_no_descriptor_is_in_error():  # R-A04
    rig = rig_of(module("    pass"), kind="synchronous").switch(on=["one"])
    assert rig.task("one").state is State.ERROR
    assert "fileno" in last(rig, news.Failed).text


def test_an_event_of_a_task_that_is_off_or_not_synchronous_is_nothing():  # R-A04
    rig = rig_of(SYNC, kind="synchronous").spawn("two", SYNC, aliases={"N": "M"}).switch(on=["two"])
    for name in ("one", "two", "nobody"):
        assert rig.executive.event((HOME, name), 0) == []
    assert (rig["N"], rig["M"]) == (0, 0)


def test_an_error_in_sync_is_one_of_the_cycle():  # R-A09
    source = module(PIPE + "    def sync(self):\n        raise ValueError('planted')")
    rig = rig_of(source, kind="synchronous").switch(on=["one"])
    heard = rig.executive.event((HOME, "one"), 0)
    assert [(one.entry, one.text) for one in heard] == [("cycle", "ValueError: planted")]


# Signals


def test_a_trigger_that_finishes_goes_off_and_says_where_to_go():  # R-A07, R-A08
    rig = rig_of(cycle("return finish(flow=2, loop=True)", trigger=True)).switch(on=["one"]).run(50 * MS)
    assert rig.heard(news.Finished) == [news.Finished(HOME, "one", 2, True, 0)]
    assert rig.task("one").state is State.OFF


@pytest.mark.parametrize("flow", ["np.int64(2)", "np.uint8(2)"])
def test_numbers_of_numpy_in_a_signal_travel(flow):
    source = "import numpy as np\n" + cycle(f"return finish(flow={flow}, loop=np.bool_(True))", trigger=True)
    finished = last(rig_of(source).switch(on=["one"]).run(0), news.Finished)
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
    assert last(rig, news.Failed).text.startswith(text)
    assert rig.heard(news.Finished) == []


def test_a_task_may_switch_itself_off():  # R-A08
    rig = rig_of(cycle("return off()", passive=True)).switch(on=["one"]).run(50 * MS)
    assert last(rig, news.Changed) == news.Changed(HOME, "one", "OFF", 0, "OFF")


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
    assert rig.heard(news.Signalled) == [news.Signalled(HOME, "one", kind, number, text, 0)]
    assert rig.task("one").state is State.ON


@pytest.mark.parametrize("entry", ["init", "on", "cycle", "off", "kill", "clear"])
def test_a_warning_of_every_entry_point_is_passed_on(entry):  # R-A07
    arguments = ", inputs" if entry == "on" else ""
    body = f"    def {entry}(self{arguments}):\n        self.warn('mind')"
    if entry == "clear":
        body += "\n    def cycle(self):\n        raise ValueError"
    rig = rig_of(module(body)).switch(on=["one"]).run(0).do(command.Clear(HOME, "one"))
    rig.switch(off=["one"]).do(command.Kill(HOME, "one"))
    assert [one.text for one in rig.heard(news.Warned)] == ["mind"]


# Errors

FAILS = "    def cycle(self):\n        x = 1\n        raise ValueError('planted')\n"


def test_an_error_is_told_with_file_line_and_traceback():  # R-A18
    source = module(FAILS)
    rig = rig_of(source).switch(on=["one"]).run(0)
    failed = last(rig, news.Failed)
    line = source.splitlines().index("        raise ValueError('planted')") + 1
    assert (failed.entry, failed.text, failed.path, failed.line) == ("cycle", "ValueError: planted", "one.py", line)
    assert f'File "one.py", line {line}' in failed.traceback
    assert "executive" not in failed.traceback
    assert rig.task("one").state is State.ERROR


def test_the_modules_error_entry_comes_first_and_may_mend():  # R-A09
    source = module(FAILS + "    def error(self, fault):\n        return str(fault) == 'planted'")
    rig = rig_of(source).switch(on=["one"]).run(30 * MS)
    assert rig.heard(news.Failed) == []
    assert rig.task("one").state is State.ON


@pytest.mark.parametrize("answer", ["return False", "return None", "raise KeyError", "sys.exit()"])
def test_an_error_entry_that_gives_up_or_raises_leaves_the_error_as_it_was(answer):  # R-A09
    source = module(FAILS + f"    def error(self, fault):\n        {answer}")
    assert last(rig_of(source).switch(on=["one"]).run(0), news.Failed).text == "ValueError: planted"


def test_a_task_in_error_cycles_no_more_and_the_others_go_on():  # R-A05
    rig = Rig().spawn("bad", module(FAILS)).spawn("good", COUNTER).switch(on=["bad", "good"]).run(50 * MS)
    assert len(rig.heard(news.Failed)) == 1
    assert rig["N"] == 6


def test_a_module_that_exits_ends_nobody_else():
    rig = rig_of(cycle("sys.exit(3)")).switch(on=["one"]).run(20 * MS)
    assert last(rig, news.Failed).text == "SystemExit: 3"


def test_a_cycle_that_raises_publishes_nothing():  # law 2
    source = module("    N = OutVar('int')\n    def cycle(self):\n        self.N = 5\n        raise ValueError")
    assert rig_of(source).switch(on=["one"]).run(0)["N"] == 0


@pytest.mark.parametrize("entry", ["on", "off", "clear"])
def test_what_raises_in_another_entry_is_an_error_by_its_name(entry):  # R-A05
    arguments = ", inputs" if entry == "on" else ""
    body = f"    def {entry}(self{arguments}):\n        raise ValueError('planted')\n"
    body += "    def cycle(self):\n        raise ValueError\n" if entry == "clear" else ""
    rig = rig_of(module(body)).switch(on=["one"]).run(0)
    if entry != "on":
        rig.do(OFF if entry == "off" else command.Clear(HOME, "one"))
    assert last(rig, news.Failed).entry == entry
    assert rig.task("one").state is State.ERROR


def test_a_finish_whose_off_raises_is_an_error_and_no_finish():  # R-A08
    source = cycle("return finish()", trigger=True) + "    def off(self):\n        raise ValueError\n"
    rig = rig_of(source).switch(on=["one"]).run(0)
    assert rig.heard(news.Finished) == []
    assert rig.task("one").state is State.ERROR


def test_a_kill_that_raises_is_told_and_the_task_is_gone():  # R-A05
    rig = rig_of(module("    def kill(self):\n        raise ValueError")).do(command.Kill(HOME, "one"))
    assert [type(one) for _, one in rig.news[-2:]] == [news.Failed, news.Changed]
    assert rig.executive.tasks == {}


@pytest.mark.parametrize("when", ["init", "cycle"])
def test_a_name_that_is_no_port_is_an_error(when):  # style §3, habit 5
    rig = rig_of(module(f"    def {when}(self):\n        self.Q_REFF = 1.0")).switch(on=["one"]).run(0)
    assert "Q_REFF is no port of this module: declare it or use another name" in last(rig, news.Failed).text


def test_an_input_cannot_be_written():  # R-A02
    source = module("    X = InVar('double')\n    def cycle(self):\n        self.X = 1.0")
    assert (
        "X is an INVAR: it is read, never written" in last(rig_of(source).switch(on=["one"]).run(0), news.Failed).text
    )


# User input

ASKS = module(
    "    QMAX = InConst('double[2]')\n    goal = Input('double[2]', 'rad', 'where', low=0, high='QMAX')\n"
    "    def on(self, inputs):\n        self.goal = inputs.goal\n"
    "        if inputs.goal[0] == 0.5:\n            raise AskAgain('anywhere but there')"
)


def asking_rig():
    rig = Rig()
    rig.spawn("limit", module("    QMAX = OutConst('double[2]')\n    def init(self):\n        self.QMAX = 3.0"))
    return rig.spawn("one", ASKS)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("", ""),
        ("1", "expected 2 values"),
        ("1 2 3", "expected 2 values"),
        ("1 x", "goal[1]: expected a number"),
        ("1 3.5", "goal[1]: expected 0..3 rad, found 3.5"),
        ('"1', "double quotes"),
        ("0.5 1", "anywhere but there"),
    ],
)
def test_input_that_is_missing_or_wrong_is_asked_for_with_the_reason_until_it_is_right(line, reason):  # R-A10
    rig = asking_rig().switch(on=[command.Launch("one", line)])
    asked = last(rig, news.Asked)
    assert reason in asked.reason
    assert bool(asked.reason) == bool(reason)
    assert (asked.items[0].name, asked.items[0].count, asked.items[0].high) == ("goal", 2, (3.0, 3.0))
    assert rig.run(50 * MS).task("one").counters.cycles == 0
    rig.do(command.Answer(HOME, "one", "9 9"))
    assert "expected 0..3 rad, found 9" in last(rig, news.Asked).reason
    assert rig.task("one").state is State.ASKING
    rig.do(command.Answer(HOME, "one", "1 2")).run(rig.now)
    assert rig.task("one").state is State.ON
    assert rig.task("one").module.goal.tolist() == [1.0, 2.0]


def test_a_task_that_asks_can_be_turned_off_and_its_off_is_not_run():  # R-A10
    source = ASKS + "\n    def off(self):\n        raise ValueError('never was on')"
    rig = Rig().spawn("limit", module("    QMAX = OutConst('double[2]')")).spawn("one", source)
    rig.switch(on=["one"]).switch(off=["one"])
    assert (rig.task("one").state, rig.heard(news.Failed)) == (State.OFF, [])


# Get and set


def test_a_module_answers_get_and_set():  # R-A05
    body = "    gain = 1.0\n    def get(self, name):\n        return getattr(self, name)\n"
    body += "    def set(self, name, value):\n        setattr(self, name, float(value))"
    rig = rig_of(module(body)).do(command.Set(HOME, "one", "gain", "2.5")).do(command.Get(HOME, "one", "gain"))
    assert rig.heard(news.Got) == [news.Got(HOME, "one", "gain", "2.5"), news.Got(HOME, "one", "gain", 2.5)]


@pytest.mark.parametrize("body", ["    pass", "    def get(self, name):\n        sys.exit()"])
def test_a_get_that_raises_is_refused_and_the_task_lives_on(body):  # R-A05
    rig = rig_of(module(body)).do(command.Get(HOME, "one", "gain"))
    assert rig.heard(news.Got) == []
    assert last(rig, news.Refused).command == "get or set"
    assert rig.task("one").state is State.OFF


def test_what_cannot_travel_is_refused():
    rig = rig_of(module("    def get(self, name):\n        return 2 ** 70")).do(command.Get(HOME, "one", "x"))
    assert "OverflowError" in last(rig, news.Refused).reason


# Figures


def test_counters_count_since_the_last_status():  # R-A11, R-A17
    source = cycle("self.warn('x')", crit=2)
    rig = Rig(costs={"one": 25 * MS}).spawn("one", source).switch(on=["one"]).run(99 * MS)
    figures = last(rig.do(command.Report()), news.Statuses).tasks[0]
    assert (figures.cycle, figures.miss, figures.warn, figures.crit) == (4, 4, 4, 2)
    assert (figures.state, figures.type, figures.module, figures.reference_hz) == ("ON", "periodic", "one", 100.0)
    assert figures.measured_hz == pytest.approx(40.0)
    assert 0.0 < figures.least_us <= figures.mean_us <= figures.most_us <= figures.total_us
    again = last(rig.do(command.Report()), news.Statuses)
    assert (again.tasks[0].cycle, again.tasks[0].miss, again.tasks[0].warn, again.load) == (0, 0, 0, 0.0)


def test_the_load_is_the_share_of_time_that_tasks_took():  # R-A11
    rig = rig_of(cycle("sum(range(1000))")).switch(on=["one"]).run(100 * MS)
    statuses = last(rig.do(command.Report()), news.Statuses)
    assert statuses.rtpu == "unit"
    assert statuses.load == pytest.approx(statuses.tasks[0].total_us * 1e-6 / 0.1)


def test_a_task_without_a_rate_has_no_reference_rate():  # R-A11
    rig = rig_of(COUNTER, kind="aperiodic", frequency=None).do(command.Report())
    assert last(rig, news.Statuses).tasks[0].reference_hz == 0.0


# Devices

ARM = """
class One(Module):
    hardware = True
    F = InVar("double", "N", "force")
    X = OutVar("double", "m", "place")

    def cycle(self):
        self.X = self.device.read()[0]
        self.device.write((self.F,))

    def error(self, fault):
        return True
"""
FORCE = module(
    "    F = OutVar('double')\n    value = 1.0\n    def on(self, inputs):\n        self.F = 0.0\n"
    "    def cycle(self):\n        self.F = self.value"
)


def arm_rig(error_mends=True):
    source = HEAD + ARM if error_mends else HEAD + ARM.partition("    def error")[0]
    return Rig(MassWorld()).spawn("arm", source, device="m0").spawn("force", FORCE, rank=1)


def order_of(rig):
    rig.bus.deliver()
    return rig.bus.world.state("m0")[1]


def test_hardware_without_a_device_cannot_come_on():  # law 16
    rig = Rig().spawn("arm", HEAD + ARM).switch(on=["arm"])
    assert last(rig, news.Failed).text == "ModuleError: a hardware task needs a device"


def test_hardware_commands_nothing_until_all_inputs_are_fresh():  # law 4
    rig = arm_rig().switch(on=["arm"]).run(100 * MS)
    assert rig.bus.world.state("m0")[1] == 1.0  # held
    rig.switch(on=["force"]).run(500 * MS)
    assert rig.bus.world.state("m0")[1] == 0.0  # driven
    assert rig["X"] > 0.0


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_nan_at_the_copy_in_is_error_plus_hold(value):  # law 5
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    rig.task("force").module.value = value
    rig.run(120 * MS)
    assert "expected finite inputs, found NaN or infinity in F" in last(rig, news.Failed).text
    assert rig.task("arm").state is State.ERROR
    assert order_of(rig) == 1.0


def test_what_an_old_nan_left_behind_does_not_keep_hardware_off():  # laws 4, 5
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    rig.task("force").module.value = float("nan")
    rig.run(120 * MS).do(command.Clear(HOME, "arm"))
    rig.task("force").module.value = 1.0
    rig.switch(off=["force"]).switch(on=["arm", "force"]).run(300 * MS)
    assert rig.task("arm").state is State.ON


@pytest.mark.parametrize("mends", [True, False])
def test_nan_written_to_the_device_is_a_hold_and_an_error_unless_mended(mends):  # law 5
    rig = arm_rig(mends).switch(on=["arm", "force"]).run(100 * MS)
    rig.task("arm").module.cycle = lambda: rig.task("arm").module.device.write((float("nan"),))
    rig.run(110 * MS)
    assert rig.task("arm").state is (State.ON if mends else State.ERROR)
    assert order_of(rig) == 1.0


def test_a_device_that_falls_silent_is_an_error():  # law 17
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    rig.bus.step = lambda until: None
    rig.run(300 * MS)
    assert "device m0 has published nothing for 60 ms" in last(rig, news.Failed).text
    assert (last(rig, news.Failed).now_ns - 100 * MS) <= 80 * MS


@pytest.mark.parametrize(
    "order", [OFF, command.Kill(HOME, "arm"), command.Stop("panic"), command.Quit(), command.Fail("server gone")]
)
def test_a_device_is_left_in_hold_whatever_ends_the_task(order):  # laws 17, 27
    if isinstance(order, command.Switch):
        order = command.Switch(HOME, ("arm",), (), ())
    rig = arm_rig().switch(on=["arm", "force"]).run(100 * MS)
    assert order_of(rig) == 0.0
    rig.do(order)
    assert order_of(rig) == 1.0


def test_a_stop_turns_everything_off_and_is_latched():  # law 27
    rig = arm_rig().switch(on=["arm", "force"]).run(50 * MS).do(command.Stop("panic"))
    assert {one.state for one in rig.executive.tasks.values()} == {State.OFF}
    rig.switch(on=["arm"]).spawn("more", module())
    assert [one.reason for one in rig.heard(news.Refused)] == ["this unit was stopped"] * 2
    assert rig.run(100 * MS).executive.next_release() is None


def test_devices_that_are_gone_put_their_tasks_in_error_and_no_others():  # law 17
    rig = arm_rig().switch(on=["arm", "force"]).run(50 * MS).do(command.Fail("the device server died"))
    assert (last(rig, news.Failed).entry, last(rig, news.Failed).text) == (
        "device", "ModuleError: the device server died",
    )  # fmt: skip
    assert rig.task("force").state is State.ON


def test_a_tripped_drive_is_cleared_though_the_task_comes_on_at_once():  # law 17
    source = HEAD + ARM.replace("        self.X =", "        assert not self.device.is_tripped\n        self.X =")
    source = source.partition("    def error")[0] + "    def clear(self):\n        self.device.clear()\n"
    rig = Rig(MassWorld()).spawn("arm", source, device="m0").spawn("force", FORCE, rank=1)
    rig.switch(on=["arm", "force"]).run(100 * MS)
    rig.bus.world._turn(rig.bus.world._masses["m0"], Drive.TRIPPED, "planted")
    rig.run(130 * MS)
    assert rig.task("arm").state is State.ERROR
    rig.do(command.Clear(HOME, "arm")).switch(on=["arm"]).run(300 * MS)
    assert rig.task("arm").state is State.ON
    assert rig.bus.world.state("m0")[1] == 0.0


# What its owner sees


def test_the_watch_is_told_whose_code_runs():
    told = []
    rig = Rig()
    rig.executive._watch, rig.executive._watches = told.append, True
    rig.spawn("one", COUNTER).switch(on=["one"]).run(0)
    assert {name for name in told if name} == {f"{HOME}/one"}
    assert told[-1] == ""


def test_a_release_is_known_beforehand():
    rig = rig_of(COUNTER)
    assert rig.executive.next_release() is None
    assert rig.executive.run_next(0) is None
    assert rig.switch(on=["one"]).executive.next_release() == 0
    assert rig.run(0).executive.next_release() == 10 * MS


def test_a_task_that_is_killed_and_spawned_again_within_a_period_lives():
    rig = rig_of(COUNTER)
    for _ in range(4):
        rig.switch(on=["one"]).run(rig.now).do(command.Kill(HOME, "one")).spawn("one", COUNTER)
    rig.switch(on=["one"]).run(30 * MS)
    assert rig["N"] == 4 + 4
