"""One running task: its entry points in the order of the law."""

from array import array
from types import SimpleNamespace

import pytest

from onika.model.lifecycle import IllegalTransition, LifecycleInput, State
from onika.module import InBoth, InConst, Input, InVar, Local, Module, ModuleError, OutBoth, OutConst, OutVar
from onika.runtime.command import BoundPort
from onika.words.shape import Shape

MS = 1_000_000


class Steps(Module):
    """Notes what it saw at each entry."""

    C = InConst("double")
    B = InBoth("double")
    V = InVar("double")
    D = OutConst("double")
    E = OutBoth("double")
    W = OutVar("double")

    def init(self):
        self.seen = [("init", self.C, self.B, self.V)]
        self.D, self.E, self.W = 1.0, 2.0, 3.0

    def on(self, inputs):
        self.seen.append(("on", self.C, self.B, self.V, self.E, self.W))
        self.W += 10.0

    def cycle(self):
        self.seen.append(("cycle", self.B, self.V, self.now))
        self.E, self.W = 20.0, 30.0

    def sync(self):
        self.seen.append(("sync", self.V))
        self.W = 40.0

    def off(self):
        self.W = 99.0


NOTHING = SimpleNamespace()


def test_init_takes_constants_and_first_values_in_and_gives_them_out(place):  # law 3, R-A02
    task = place.task(Steps)
    place.write(C=5.0, B=6.0, V=7.0)
    task.init()
    assert task.module.seen == [("init", 5.0, 6.0, 0.0)]
    assert [place.table.value(name) for name in "DEW"] == [1.0, 2.0, 0.0]


def test_on_takes_all_inputs_in_and_starts_from_its_own_preloaded_outputs(place):  # law 3
    task = place.task(Steps)
    task.init()
    place.write(C=5.0, B=6.0, V=7.0, E=8.0, W=9.0)
    task.on(0, NOTHING)
    assert task.module.seen[-1] == ("on", 5.0, 6.0, 7.0, 8.0, 9.0)
    assert place.table.value("W") == 19.0


def test_a_cycle_copies_in_works_and_copies_out(place):  # law 2
    task = place.task(Steps)
    task.init()
    task.on(0, NOTHING)
    place.write(B=1.0, V=2.0)
    task.cycle(30 * MS)
    assert task.module.seen[-1] == ("cycle", 1.0, 2.0, pytest.approx(0.03))
    assert (place.table.value("E"), place.table.value("W")) == (20.0, 30.0)
    assert task.counters.cycles == 1


def test_an_event_is_a_cycle_through_sync(place):  # R-A04
    task = place.task(Steps)
    task.init()
    place.write(V=2.0)
    task.event(0)
    assert task.module.seen[-1] == ("sync", 2.0)
    assert (place.table.value("W"), task.counters.cycles) == (40.0, 1)


def test_off_publishes_nothing(place):  # law 3
    task = place.task(Steps)
    task.init()
    task.off()
    assert place.table.ring("W").count == 0


def test_a_first_value_that_was_never_written_is_warned_of(place):  # reading 6
    task = place.task(Steps)
    task.init()
    assert [str(warning) for warning in task.warnings] == ["B was never written: its first value here is zero"]
    place.write(B=1.0)
    other = place.task(Steps)
    other.init()
    assert other.warnings == []


def test_what_is_in_force_is_named_as_the_module_names_it(place):  # law 3
    task = place.task(Steps)
    task.init()
    place.write(W=1.0)
    task.on(0, NOTHING)
    assert task.module.continues("W")
    assert not task.module.continues("V")


def test_the_state_follows_the_table_of_lifecycles(place):  # law 11
    task = place.task(Steps)
    with pytest.raises(IllegalTransition):
        task.step(LifecycleInput.ON)
    assert task.state is State.WAITING
    task.step(LifecycleInput.INITIALISED)
    assert task.state is State.OFF


def test_user_input_is_known_once_the_constants_are(place):  # R-A10
    class Asks(Module):
        N = InConst("double")
        goal = Input("double", "m", "where", high="N")

    task = place.task(Asks)
    place.write(N=2.0)
    task.init()
    assert task.input.items[0].high == (2.0,)
    assert task.parse("1.5").goal == 1.5
    assert vars(place.task(Steps).parse("anything")) == {}


def test_a_clear_initialises_what_never_was(place):
    class Fails(Module):
        tries = 0

        def init(self):
            self.tries += 1
            if self.tries == 1:
                raise ModuleError("not yet")

    task = place.task(Fails)
    with pytest.raises(ModuleError):
        task.init()
    task.clear()
    task.clear()
    assert (task.is_initialised, task.module.tries) == (True, 2)


def test_another_rate_is_another_period_and_another_dt(place):  # R-A04
    task = place.task(Steps)
    assert task.change_rate(50.0) == 20 * MS
    assert (task.period_ns, task.module.dt) == (20 * MS, 0.02)


def test_what_is_prepared_is_not_seen_by_others_before_it_is_published(place):  # law 21
    task = place.task(Steps)
    task.prepare(task.module.init)
    assert (task.is_initialised, place.table.ring("D").count, place.table.ring("E").count) == (True, 0, 0)
    task.publish_constants(first_values=False)
    assert [place.table.value(name) for name in "DE"] == [1.0, 0.0]
    task.begin(0, NOTHING)
    assert place.table.ring("W").count == 0
    task.publish()
    assert place.table.value("W") == 10.0


class Counts(Module):
    """Has a shape that depends on a constant."""

    N = InConst("int")
    GAIN = Local("double", default=1.0)
    Q = InVar("double[N]")
    SUM = OutConst("double")

    def init(self):
        self.SUM = self.GAIN * self.N

    def reinit(self):
        self.again = True
        self.init()


def test_a_reinit_takes_constants_in_and_gives_them_out_anew(place):  # R-A01, law 3
    task = place.task(Counts, shapes={"N": 2})
    place.table.ring("N").write(array("i", [2]))
    task.init()
    place.table.ring("N").write(array("i", [5]))
    task.reinit()
    assert (task.module.N, task.module.again, place.table.value("SUM")) == (5, True, 5.0)


def test_a_reinit_that_raises_leaves_a_task_that_a_clear_initialises(place):  # R-A05
    task = place.task(Counts, shapes={"N": 2})
    task.init()
    task.module.reinit = lambda: 1 / 0
    with pytest.raises(ZeroDivisionError):
        task.reinit()
    assert not task.is_initialised
    task.clear()
    assert task.is_initialised


def test_ports_are_bound_to_other_entries_of_another_shape_and_the_instance_stays(place):  # law 12
    task = place.task(Counts, shapes={"N": 2})
    place.table.ring("N").write(array("i", [2]))
    task.init()
    module = task.module
    entry = place.table.entry("Q7", Shape.parse("double[7]"))
    task.rebind((BoundPort("Q", "Q", "double[7]", entry.offset),), (("GAIN", ("3",)),))
    assert task.module is module
    assert (module.Q.shape, module.GAIN, module.N, module.SUM) == ((7,), 3.0, 2, 2.0)
    assert not task.is_initialised
    place.table.ring("Q7").write(array("d", range(7)))
    task.look()
    assert module.Q.tolist() == list(range(7))


@pytest.mark.parametrize(
    ("port", "local"),
    [
        (BoundPort("Q", "Q", "nonsense[7]", 0), None),
        (BoundPort("Q", "Q", "double[7]", 0), (("GAIN", ("much",)),)),
        (BoundPort("Q", "Q", "double[7]", 1 << 20), None),
    ],
)
def test_what_cannot_be_bound_leaves_all_as_it_was(place, port, local):  # law 12
    task = place.task(Counts, shapes={"N": 2})
    task.init()
    before = task.spawn, task.binding, task.module.Q
    with pytest.raises((ValueError, TypeError)):
        task.rebind((port,), local)
    assert (task.spawn, task.binding) == before[:2]
    assert task.module.Q is before[2]
    assert (task.module.GAIN, task.is_initialised) == (1.0, True)


def test_a_task_without_a_device_holds_nothing(place):
    task = place.task(Steps)
    task.hold()
    assert task.device is None
