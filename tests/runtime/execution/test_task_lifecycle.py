"""The lives of tasks: commands in every state, switches, kinds of tasks."""

import pytest
from msgspec import structs

from kit.labs.module_source import COUNTER, HEAD, module
from kit.runtime.executive_rig import HOME, ExecutiveRig, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news

MS = 1_000_000


# Spawning


def test_a_task_is_off_after_it_was_spawned():  # R-A05
    rig = rig_of(module())
    assert rig.news_of(news.Initialised) == [news.Initialised(HOME, "one")]
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
    assert reason in rig.last(news.Refused).reason
    assert rig.executive.tasks == {}


def test_a_second_task_of_one_name_is_refused():  # R-A06
    rig = rig_of(module()).spawn("one", module())
    assert rig.last(news.Refused).reason == "a task of this name lives here already"


def test_one_module_serves_many_tasks_that_share_nothing():  # R-A01, law 14
    source = HEAD + (
        "seen = []\nclass One(Module):\n    N = OutVar('int')\n"
        "    def cycle(self):\n        seen.append(1)\n        self.N = len(seen)\n"
    )
    rig = ExecutiveRig().spawn("a", source, aliases={"N": "A"}).spawn("b", source, aliases={"N": "B"}, frequency=50.0)
    rig.switch(on=["a", "b"]).run(40 * MS)
    assert (rig["A"], rig["B"]) == (5, 3)


def test_an_init_that_raises_is_an_error_and_clear_initialises_anew():  # R-A05
    source = module(
        "    N = OutVar('int')\n    tried = []\n    def init(self):\n        self.tried.append(1)\n"
        "        if len(self.tried) == 1:\n            raise ModuleError('not yet')"
    )
    rig = rig_of(source)
    assert (rig.last(news.Failed).entry, rig.task("one").state) == ("init", State.ERROR)
    rig.do(command.Clear(HOME, "one"))
    assert rig.news_of(news.Initialised) == [news.Initialised(HOME, "one")]
    assert rig.task("one").module.tried == [1, 1]


# Commands that a state does not allow: refused, and nothing has changed


def in_state(state):
    asks = module("    x = Input('int')\n    def cycle(self):\n        raise ValueError('planted')")
    rig = ExecutiveRig().spawn("one", asks)
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
    "reinit": (command.Reinit(HOME, "one"), {State.OFF: State.OFF}),
    "rebind": (command.Rebind(HOME, "one", ()), {State.OFF: State.OFF, State.ERROR: State.ERROR}),
}


SAYS = {"reinit": news.Reinitialised, "rebind": news.Rebound}


@pytest.mark.parametrize("state", [State.OFF, State.ASKING, State.ON, State.ERROR, State.KILLED])
@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_does_what_the_table_says_or_is_refused_and_changes_nothing(name, state):  # R-A05, law 11
    order, leads_to = COMMANDS[name]
    rig = in_state(state)
    assert state_of(rig) is state
    count = len(rig.news)
    rig.do(order)
    assert state_of(rig) is leads_to.get(state, state)
    events = [event for _, event in rig.news[count:]]
    if state in leads_to:
        assert [type(event) for event in events] == [SAYS.get(name, news.Changed)]
        assert getattr(events[0], "state", leads_to[state].value) == leads_to[state].value
    elif name == "off":
        assert events == []  # turning off what is off harms nothing
    else:
        assert [type(event) for event in events] == [news.Refused]
        assert events[0].reason


@pytest.mark.parametrize("order", [command.Get(HOME, "nobody", "x"), command.Set(HOME, "nobody", "x", "1")])
def test_a_task_that_is_not_there_is_refused_by_name(order):
    assert ExecutiveRig().do(order).news_of(news.Refused) == [
        news.Refused(HOME, "nobody", "get or set", "no such task")
    ]


# Switches


def test_a_switch_turns_off_before_it_turns_on_with_no_cycle_in_between():  # laws 2, 3
    rig = ExecutiveRig().spawn("a", COUNTER).spawn("b", COUNTER).switch(on=["a"]).run(5 * MS)
    rig.switch(off=["a"], on=["b"])
    changes = [(event.task, event.state) for event in rig.news_of(news.Changed)]
    assert changes == [("a", "ON"), ("a", "OFF"), ("b", "ON")]
    assert rig.run(15 * MS)["N"] == 1 + 2


def test_the_first_cycle_after_on_is_told_once():
    rig = rig_of(COUNTER).switch(on=["one"]).run(30 * MS).switch(off=["one"]).switch(on=["one"]).run(50 * MS)
    assert [event.at_ns for event in rig.news_of(news.Cycled)] == [0, 30 * MS]


def test_a_reference_stays_in_force_while_it_is_read_and_a_stale_one_does_not():  # law 3, reading 45
    """cmove, jmove, cmove: the joint reference goes on without a jump; X_REF stood still, so it is not continued."""
    source = module(
        "    REF = OutVar('double')\n    Q = InVar('double')\n    def on(self, inputs):\n"
        "        self.began = self.continues('REF')\n        self.REF += 1.0"
    )
    rig = ExecutiveRig()
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


def meeting_rig():
    """Three tasks in each of three subsystems; the first of them in data flow is named last."""
    rig = ExecutiveRig()
    for flow in ("f0", "f1", "f2"):
        rig.views[f"table:{flow}"] = rig.views[f"table:{HOME}"]
        for rank, name in enumerate("cba"):
            spawn = rig.spawn_of(name, COUNTER, aliases={"N": f"N_{name}_{flow}".upper()}, rank=rank)
            rig.do(structs.replace(spawn, subsystem=flow))
    return rig


def together(on, off=()):
    launches = tuple(command.Launch(name) for name in on)
    return command.Together(tuple(command.Switch(flow, tuple(off), (), launches) for flow in ("f0", "f1", "f2")))


def test_flows_that_are_switched_together_cycle_from_one_instant_the_first_of_each_first():  # R-E04
    rig = meeting_rig()
    rig.now = 3 * MS
    rig.do(together(on="abc")).run(3 * MS)
    first = rig.news_of(news.Cycled)
    assert {event.at_ns for event in first} == {3 * MS}
    expected = [(flow, name) for name in "cba" for flow in ("f0", "f1", "f2")]
    assert [(event.subsystem, event.task) for event in first] == expected


def test_flows_that_come_on_slowly_still_cycle_first_at_one_instant():  # R-E04: `on` of one makes no other one late
    rig = meeting_rig().do(together(on="abc"))
    rig.now = 37 * MS
    rig.run(37 * MS)
    assert {event.at_ns for event in rig.news_of(news.Cycled)} == {37 * MS}
    assert {task.slot.missed for task in rig.executive.tasks.values()} == {0}


def test_of_flows_that_are_switched_together_all_go_off_before_one_comes_on():  # R-E04
    rig = meeting_rig().do(together(on="a")).run(0)
    rig.news.clear()
    rig.do(together(on="b", off="a"))
    assert [(event.task, event.state) for event in rig.news_of(news.Changed)] == [("a", "OFF")] * 3 + [("b", "ON")] * 3


def test_a_flow_that_asks_does_not_hold_up_those_it_is_switched_with():  # R-E04, R-A10
    rig = meeting_rig().spawn("asks", module("    G = Input('double', 'm', 'goal')"))
    asks = command.Switch(HOME, (), (), (command.Launch("asks"),))
    rig.do(command.Together((asks, *together(on="a").switches))).run(0)
    assert len(rig.news_of(news.Asked)) == 1
    assert len(rig.news_of(news.Cycled)) == 3


def test_what_another_subsystem_forgets_is_none_of_ours():  # R-A06
    rig = rig_of(COUNTER).switch(on=["one"]).run(0)
    rig.do(command.Switch("other", (), ("N",), ()))
    assert rig.table.ring("N").mark == 0


@pytest.mark.parametrize("rate", [0.0, -1.0, float("nan"), float("inf"), 2e9])
def test_a_rate_that_is_none_is_refused_and_the_old_one_stays(rate):  # R-A04
    rig = rig_of(COUNTER).switch(on=["one"], rates=[("one", rate)])
    assert "expected a rate" in rig.last(news.Refused).reason
    assert rig.run(20 * MS)["N"] == 3


def test_a_rate_given_at_on_holds_from_then_on():  # R-A04
    rig = rig_of(COUNTER).switch(on=[command.Launch("one", "", 200.0)]).run(20 * MS)
    assert rig["N"] == 5
    assert rig.task("one").module.dt == 0.005
    assert rig.switch(rates=[("nobody", 5.0)]).news_of(news.Refused)[0].reason == "no such task"


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
    events = rig.executive.event((HOME, "one"), 200 * MS)
    assert rig["N"] == 1
    assert [type(event) for event in events] == [news.Cycled, news.Warned]


def test_a_synchronous_task_waits_for_its_descriptor_while_it_is_on():  # R-A04
    rig = rig_of(SYNC, kind="synchronous").switch(on=["one"])
    assert list(rig.executive.events().values()) == [(HOME, "one")]
    rig.switch(off=["one"])
    assert rig.executive.events() == {}


def test_a_synchronous_module_that_names_no_descriptor_is_in_error():  # R-A04
    rig = rig_of(module("    pass"), kind="synchronous").switch(on=["one"])
    assert rig.task("one").state is State.ERROR
    assert "fileno" in rig.last(news.Failed).text


def test_an_event_of_a_task_that_is_off_or_not_synchronous_is_nothing():  # R-A04
    rig = rig_of(SYNC, kind="synchronous").spawn("two", SYNC, aliases={"N": "M"}).switch(on=["two"])
    for name in ("one", "two", "nobody"):
        assert rig.executive.event((HOME, name), 0) == []
    assert (rig["N"], rig["M"]) == (0, 0)


def test_an_error_in_sync_is_one_of_the_cycle():  # R-A09
    source = module(PIPE + "    def sync(self):\n        raise ValueError('planted')")
    rig = rig_of(source, kind="synchronous").switch(on=["one"])
    events = rig.executive.event((HOME, "one"), 0)
    assert [(event.entry, str(event.text)) for event in events] == [("cycle", "ValueError: planted")]


# After a stop


def test_after_a_reset_tasks_come_on_again():  # law 27
    rig = rig_of(COUNTER).do(command.Stop()).switch(on=["one"])
    assert rig.task("one").state is State.OFF
    assert rig.do(command.Reset()).switch(on=["one"]).task("one").state is State.ON
