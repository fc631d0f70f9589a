"""Signals, figures and devices of the tasks on one processing unit, and what its owner sees.

That it runs what is due in the right order is proved beside the reference, in `test_reference.py`.
"""

import select
import shutil
import subprocess

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.ring.device import Drive
from onika.runtime import command, news
from onika.testing.outsider import Outsider
from onika.testing.rig import HOME, Rig
from onika.testing.source import COUNTER, HEAD, cycle, module
from onika.testing.worlds import MassWorld

MS = 1_000_000


def rig_of(source, **given):
    return Rig().spawn("one", source, **given)


def last(rig, kind):
    return rig.heard(kind)[-1]


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
    "order",
    [
        command.Switch(HOME, ("arm",), (), ()),
        command.Kill(HOME, "arm"),
        command.Stop("panic"),
        command.Quit(),
        command.Fail("server gone"),
    ],
)
def test_a_device_is_left_in_hold_whatever_ends_the_task(order):  # laws 17, 27
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
    rig.executive._calls.watch = told.append
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


# Cycles that are no Python method


CALLABLES = {
    "partial on the class": "    cycle = functools.partial(STORE.append, None)",
    "partial by init": "    def init(self):\n        self.cycle = functools.partial(self.work, 2)",
    "object with __call__": "    def init(self):\n        self.cycle = Work(self)",
    "lambda": "    def init(self):\n        self.cycle = lambda: self.work(2)",
    "builtin": "    def init(self):\n        self.cycle = self.N_.__iter__",
}


@pytest.mark.parametrize("kind", CALLABLES)
def test_a_cycle_is_anything_that_can_be_called(kind):  # R-A01
    head = (
        "import functools\nSTORE = []\nclass Work:\n    def __init__(self, m):\n        self.m = m\n"
        "    def __call__(self):\n        self.m.work(2)\n"
    )
    body = "    N = OutVar('int')\n    N_ = ()\n    def work(self, n):\n        self.N += n\n" + CALLABLES[kind]
    if kind == "builtin":
        body = body.replace("self.N_.__iter__", "[].clear")
    rig = rig_of(head + module(body)).switch(on=["one"]).run(20 * MS)
    assert (rig.task("one").state, rig.task("one").counters.cycles) == (State.ON, 3)
    expected = {"partial on the class": 0, "builtin": 0}.get(kind, 6)
    assert rig["N"] == expected


C_SOURCE = """
void spring(const double *place, const double *gain, double *force) {
    for (int i = 0; i < 6; i++) force[i] = -gain[0] * place[i];
}
int counted(int *n) { return 0 * (*n += 1); }
int broken(void) { return 7; }
"""
C_MODULE = """
import ctypes
import functools
from onika.module import InVar, Module, OutVar

LIBRARY = ctypes.CDLL({library!r})

class Spring(Module):
    Q_MEZ = InVar("double[6]", "rad", "place")
    GAIN = InVar("double", "N", "gain")
    TAU = OutVar("double[6]", "N m", "torque")
    N = OutVar("int")

    def init(self):
        LIBRARY.spring.restype = None
        pointers = [ctypes.c_void_p(self.buffer(name).ctypes.data) for name in ("Q_MEZ", "GAIN", "TAU")]
        count = ctypes.c_void_p(self.buffer("N").ctypes.data)
        self.cycle = {cycle}
"""


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("there is no C compiler (cc) here to make a C function with")
    folder = tmp_path_factory.mktemp("c")
    (folder / "spring.c").write_text(C_SOURCE)
    subprocess.run([compiler, "-shared", "-fPIC", "-o", folder / "spring.so", folder / "spring.c"], check=True)
    return str(folder / "spring.so")


def test_a_c_function_cycles_on_the_memory_of_the_ports(library):  # R-A01
    source = C_MODULE.format(library=library, cycle="functools.partial(LIBRARY.spring, *pointers)")
    rig = rig_of(source)
    rig.table.ring("Q_MEZ").write(np.arange(6.0).tobytes())
    rig.table.ring("GAIN").write(np.array([2.0]).tobytes())
    rig.switch(on=["one"]).run(20 * MS)
    assert rig["TAU"].tolist() == [0.0, -2.0, -4.0, -6.0, -8.0, -10.0]
    rig.table.ring("GAIN").write(np.array([1.0]).tobytes())
    assert rig.run(30 * MS)["TAU"].tolist() == [0.0, -1.0, -2.0, -3.0, -4.0, -5.0]


def test_the_zero_of_a_c_function_is_no_signal_and_another_number_is_an_error(library):  # R-A01
    source = C_MODULE.format(library=library, cycle="functools.partial(LIBRARY.counted, count)")
    assert rig_of(source).switch(on=["one"]).run(20 * MS)["N"] == 3
    rig = rig_of(C_MODULE.format(library=library, cycle="LIBRARY.broken")).switch(on=["one"]).run(0)
    assert last(rig, news.Failed).text == "TypeError: expected a signal or None from cycle, found 7"


def test_a_function_compiled_by_numba_cycles():  # R-A01
    pytest.importorskip("numba", reason="numba is not installed here; nothing of Onika needs it")
    source = (
        "import functools\nimport numba\nfrom onika.module import Module, OutVar\n"
        "@numba.njit\ndef add(n):\n    n[0] += 1\n"
        "class One(Module):\n    N = OutVar('int')\n    def init(self):\n"
        "        self.cycle = functools.partial(add, self.buffer('N'))"
    )
    assert rig_of(source).switch(on=["one"]).run(20 * MS)["N"] == 3


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


def said_rig(said, launches=1):
    """A trigger, not passive where it finishes: both may not be."""
    rig = rig_of(module(SAYS.format(said=said), trigger=said.startswith("finish")))
    for run in range(launches):
        rig.switch(on=[command.Launch("one", activation=run)])
    return rig


@pytest.mark.parametrize("said", TABLE_9)
def test_the_unit_answers_each_signal_as_table_9_says(said):  # R-A07
    kind, state = TABLE_9[said]
    rig = said_rig(said).run(0)
    heard = [one for _, one in rig.news if isinstance(one, kind) and getattr(one, "state", "OFF") == "OFF"]
    assert len(heard) == 1
    assert rig.task("one").state is state
    if kind is news.Finished:
        assert (heard[0].flow, heard[0].loop) == ((1, True) if "flow" in said else (0, False))
    if said.startswith("user"):
        assert (heard[0].kind, heard[0].number) == ("USER", int(said[12:14]))


@pytest.mark.parametrize("said", TABLE_9)
def test_a_signal_that_comes_twice_is_told_twice_only_where_the_task_is_still_on(said):  # R-A07
    kind, state = TABLE_9[said]
    rig = said_rig(said).run(10 * MS)
    heard = [one for _, one in rig.news if isinstance(one, kind) and getattr(one, "state", "OFF") == "OFF"]
    assert len(heard) == (2 if state is State.ON else 1)


@pytest.mark.parametrize("said", TABLE_9)
def test_a_signal_of_each_activation_is_told_apart(said):  # R-A07
    kind, _ = TABLE_9[said]
    rig = said_rig(said).run(0).switch(off=["one"]).do(command.Clear(HOME, "one"))
    rig.switch(on=[command.Launch("one", activation=9)]).run(rig.now)
    numbers = {one.activation for _, one in rig.news if isinstance(one, kind) and hasattr(one, "activation")}
    assert numbers == ({0, 9} if kind is not news.Warned else set())


@pytest.mark.parametrize("said", TABLE_9)
def test_a_signal_that_comes_late_is_no_word_of_a_task_that_is_off(said):  # R-A07, R-A08
    """A synchronous task whose event arrives after it was turned off: nothing is called, nothing told."""
    body = SAYS.format(said=said).replace("def cycle", "def sync") + PIPE
    rig = rig_of(module(body, trigger=said.startswith("finish")), kind="synchronous").switch(on=["one"])
    rig.switch(off=["one"])
    heard = len(rig.news)
    assert rig.executive.event((HOME, "one"), 0) == []
    assert (len(rig.news), rig.task("one").state) == (heard, State.OFF)
    rig.do(command.Kill(HOME, "one"))


@pytest.mark.parametrize("said", TABLE_9)
def test_a_signal_in_the_cycle_in_which_everything_is_stopped_is_told_first(said):  # R-A07, law 27
    kind, _ = TABLE_9[said]
    rig = said_rig(said)
    rig._react = lambda one: [command.Stop("panic")] if isinstance(one, news.Cycled) else []
    rig.run(50 * MS)
    assert any(isinstance(one, kind) for _, one in rig.news)
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


# Tasks with an outside partner

ASKS = """
    N = OutVar('int')
    PARTNER = Local('line')
    PATIENCE = Local('double', default=10.0)
    def init(self):
        self.partner = Partner(self.PARTNER, patience_s=self.PATIENCE)
    def cycle(self):
        self.partner.ask('count', n=self.N)
    def sync(self):
        self.N = self.partner.answer.number('n', -100, 100)
"""


@pytest.fixture
def outsider(tmp_path):
    with Outsider(tmp_path) as made:
        yield made


def asking(outsider, patience="10.0", body=ASKS, kind="synchronous", **flags):
    """A rig whose task `one` is ON and asks this partner."""
    local = (("PARTNER", (outsider.address,)), ("PATIENCE", (patience,)))
    return rig_of(module(body, **flags), kind=kind, local=local).switch(on=["one"])


def settle(rig):
    """Wait as an RTPU does, and run the task whose event has come, until its question is settled."""
    while rig.executive.owed() or rig.executive.settled():
        ready, _, _ = select.select(list(rig.executive.events()), [], [], 0.01)
        if ready or rig.executive.settled():
            rig._hear(rig.executive.event((HOME, "one"), rig.now), rig.now)


def test_a_task_with_a_partner_asks_at_its_rate_and_only_after_the_answer(outsider):  # R-F04
    rig = asking(outsider).run(55 * MS)
    call = outsider.accept()
    asked = call.read()
    assert (asked["id"], asked["task"], rig.task("one").counters.cycles) == (1, "rig/one", 1)
    assert rig.executive.next_release() is None, "until the answer it is not due again"
    call.answer(asked, n=7)
    rig.now = 55 * MS
    settle(rig)
    assert (rig["N"], rig.executive.next_release()) == (7, 60 * MS)
    rig.run(65 * MS)
    assert call.read()["n"] == 7
    assert rig.task("one").slot.missed == 0


def test_other_tasks_never_wait_for_a_partner(outsider):  # R-F04
    rig = asking(outsider).spawn("two", COUNTER, aliases={"N": "M"}).switch(on=["two"]).run(95 * MS)
    assert rig["M"] == 10
    assert rig.executive.owed() == [rig.task("one").partner.fileno()]
    assert list(rig.executive.speaking) == [(HOME, "one")]


@pytest.mark.parametrize("said", [b"nonsense\n", b'{"id": 1, "n": NaN}\n', b'{"id": 1, "n": 1e999}\n'])
@pytest.mark.parametrize("passive", [False, True])
def test_without_an_answer_a_passive_task_falls_silent_and_any_other_has_a_fault(outsider, said, passive):  # R-F04
    rig = asking(outsider, passive=passive).run(5 * MS)
    call = outsider.accept()
    call.read()
    call.say(said)
    settle(rig)
    state = State.OFF if passive else State.ERROR
    assert (rig.task("one").state, rig["N"]) == (state, 0)
    text = last(rig, news.Warned).text if passive else last(rig, news.Failed).text
    assert f"partner {outsider.address}: expected" in text
    if passive:
        assert text.endswith("it goes off")
        assert last(rig, news.Changed).signal == "OFF"
    assert rig.executive.owed() == []


@pytest.mark.parametrize("found", ["[1]", '"7"', "null", "1e6", "true"])
def test_a_false_answer_is_a_fault_and_writes_nothing(outsider, found):  # R-F04: it never reaches an actuator
    rig = asking(outsider).run(5 * MS)
    call = outsider.accept()
    call.read()
    call.say(b'{"id": 1, "n": %s}\n' % found.encode())
    settle(rig)
    assert (rig.task("one").state, rig["N"]) == (State.ERROR, 0)
    assert "ModuleError: expected n" in last(rig, news.Failed).text


def test_a_partner_that_never_answers_costs_its_own_task_only(outsider):  # R-F04
    rig = asking(outsider, patience="0.03").run(5 * MS)
    settle(rig)
    assert "no answer within 0.03 s" in last(rig, news.Failed).text
    rig.do(command.Clear(HOME, "one")).switch(on=["one"]).run(15 * MS)
    call = outsider.accept()
    call.read()
    asked = call.read()
    call.answer(asked, n=3)
    settle(rig)
    assert (rig["N"], rig.task("one").state) == (3, State.ON)


def test_an_error_entry_may_mend_it_and_the_task_asks_again(outsider):  # R-A09, R-F04
    body = ASKS + "    def error(self, fault):\n        self.N = 99\n        return True\n"
    rig = asking(outsider, body=body).run(5 * MS)
    call = outsider.accept()
    call.answer(call.read(), error="busy")
    settle(rig)
    assert rig.task("one").state is State.ON
    rig.run(15 * MS)
    call.answer(call.read(), n=4)
    settle(rig)
    assert rig["N"] == 4


def test_a_periodic_task_looks_for_its_answer_itself_and_a_fault_is_one_of_its_cycle(outsider):  # R-F04
    body = ASKS.replace("def cycle(self):", "def on(self, inputs):") + (
        "    def cycle(self):\n        if self.partner.has_answered():\n            self.sync()\n"
    )
    rig = asking(outsider, body=body, kind="periodic").run(25 * MS)
    call = outsider.accept()
    assert rig.executive.owed()
    assert rig.executive.settled() == []
    call.answer(call.read(), n=5)
    rig.run(35 * MS)
    assert (rig["N"], rig.task("one").counters.cycles) == (5, 4)


def test_off_ends_the_question_and_kill_the_connection(outsider):  # R-F04
    rig = asking(outsider).run(5 * MS)
    call = outsider.accept()
    call.read()
    rig.switch(off=["one"])
    assert (rig.executive.owed(), list(rig.executive.speaking), call.has_ended()) == ([], [], False)
    rig.do(command.Kill(HOME, "one"))
    assert call.has_ended()


def test_an_exchange_of_the_module_has_the_new_one_ask(outsider):  # R-F04, law 21
    rig = asking(outsider).run(5 * MS)
    first = outsider.accept()
    first.read()
    local = (("PARTNER", (outsider.address,)),)
    source = module(ASKS.replace("'count'", "'sum'"))
    rig.do(command.Swap(rig.spawn_of("one", source, kind="synchronous", local=local)))
    assert first.has_ended()
    rig.run(15 * MS)
    call = outsider.accept()
    asked = call.read()
    assert asked["ask"] == "sum"
    call.answer(asked, n=6)
    settle(rig)
    assert (rig["N"], rig.executive.next_release()) == (6, 20 * MS)
