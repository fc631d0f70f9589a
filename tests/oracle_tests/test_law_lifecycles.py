"""Lives of tasks by the law, by hand; any stories are compared with the executive in `test_reference.py`."""

from onika.model.lifecycle import State
from onika.runtime.command import Kill, Launch, Rank, Reinit, Switch
from oracle.law_task import LawSwap, LawTask
from oracle.reference import Reference

MS = 1_000_000


def on(name):
    return Switch("s", (), (), (Launch(name),))


def counter(step=1.0, **more):
    def init(moment):
        moment.memory["n"] = 0.0
        moment.outputs["C"] = step

    def cycle(moment):
        moment.memory["n"] += step
        moment.outputs["N"] = moment.memory["n"]

    return LawTask("one", {"init": init, "cycle": cycle, **more}, outconst=("C",), outvar=("N",))


def take(moment):
    moment.memory.update(moment.former)


def fails(_moment):
    raise ValueError


def entries(reference):
    return [call.entry for call in reference.trace]


def test_code_that_takes_over_goes_on_with_its_memory_in_the_next_cycle():  # law 21
    reference = Reference([counter()])
    reference.run(25 * MS, [(0, on("one")), (15 * MS, LawSwap(counter(100.0, take=take)))])
    assert (reference.table["N"], reference.table["C"]) == (2.0 + 100.0, 100.0)
    assert entries(reference) == ["init", "on", "cycle", "cycle", "init", "take", "kill", "cycle"]


def test_code_that_does_not_take_over_comes_on_anew():  # law 21
    reference = Reference([counter()])
    reference.run(25 * MS, [(0, on("one")), (15 * MS, LawSwap(counter(100.0)))])
    assert reference.table["N"] == 100.0
    assert entries(reference)[4:] == ["init", "on", "off", "kill", "cycle"]


def test_code_that_fails_leaves_the_old_code_at_work():  # law 21
    for bad in ({"take": fails}, {"on": fails}):
        reference = Reference([counter()])
        reference.run(25 * MS, [(0, on("one")), (15 * MS, LawSwap(counter(100.0, **bad)))])
        assert (reference.table["N"], reference.table["C"]) == (3.0, 1.0)
        assert reference.told[-1] == (15 * MS, "one", "refused swap")


def test_only_a_task_that_is_off_is_reinitialised():  # law 10
    reference = Reference([counter(reinit=lambda moment: moment.outputs.update(C=7.0))])
    requests = [(0, Reinit("s", "one")), (0, on("one")), (5 * MS, Reinit("s", "one"))]
    reference.run(5 * MS, requests)
    assert reference.table["C"] == 7.0
    assert [word for _, _, word in reference.told] == ["reinit", "ON", "refused reinit"]


def test_what_is_killed_takes_no_rank():  # law 1
    reference = Reference([counter()])
    reference.run(0, [(0, Kill("s", "one")), (0, Rank("s", (("one", 3),)))])
    assert reference.told[-1] == (0, "one", "refused rank")
    assert reference.states == {"one": State.KILLED}
