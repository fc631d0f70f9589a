from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.model.rules.order import Ports
from onika.model.rules.reconfiguration import PlacedTask, TaskSwitch, dependents, difference, exchange

names = st.lists(st.sampled_from("abcdefgh"), unique=True)


def test_a_task_that_is_not_wanted_goes_off():  # R-A13
    assert difference(["move", "puma"], ["puma"]) == TaskSwitch(off=("move",), keep=("puma",), on=())


def test_a_task_that_is_not_yet_on_comes_on():  # R-A13
    assert difference(["puma"], ["move", "puma"]) == TaskSwitch(off=(), keep=("puma",), on=("move",))


def test_a_common_task_is_not_touched():  # R-A13
    assert difference(["puma"], ["puma"]) == TaskSwitch(off=(), keep=("puma",), on=())


def test_from_nothing_everything_comes_on():
    assert difference([], ["move", "puma"]) == TaskSwitch(off=(), keep=(), on=("move", "puma"))


def test_to_nothing_everything_goes_off():
    assert difference(["move", "puma"], []) == TaskSwitch(off=("move", "puma"), keep=(), on=())


def test_off_keeps_the_order_of_what_is_on_and_the_others_that_of_what_is_wanted():
    assert difference(["d", "b", "c", "a"], ["e", "a", "d", "f"]) == TaskSwitch(("b", "c"), ("a", "d"), ("e", "f"))


def test_a_task_named_twice_is_switched_once():
    assert difference(["a", "a"], ["b", "b"]) == TaskSwitch(off=("a",), keep=(), on=("b",))


@settings(max_examples=examples(100), deadline=None)
@given(names, names)
def test_carrying_a_change_out_gives_what_is_wanted(on_now, wanted):
    change = difference(on_now, wanted)
    assert (set(on_now) - set(change.off)) | set(change.on) == set(wanted)
    assert set(change.off).isdisjoint(change.keep)
    assert set(change.keep).isdisjoint(change.on)
    assert set(change.keep) == set(on_now) & set(wanted)


# Exchange


def placed(name, inconst=(), outconst=(), module="", device=None):
    return PlacedTask(Ports(name, tuple(inconst), tuple(outconst)), module or name, device)


def test_only_who_excludes_a_newcomer_is_killed_first():  # reading 14
    living = [placed("puma", device="boxes:left"), placed("move"), placed("watch")]
    new = [placed("puma2", device="boxes:left"), placed("ramp", module="move")]
    result = exchange(living, ["puma", "move", "watch"], new)
    assert result.kill == ("puma", "move", "watch")
    assert result.kill_first == ("puma", "move")


def test_a_task_is_exchanged_for_one_of_its_name():  # R-A13
    result = exchange([placed("move")], ["move"], [placed("move", module="other")])
    assert (result.keep, result.kill_first, result.spawn) == ((), ("move",), ("move",))


def test_two_without_a_device_do_not_exclude_each_other():
    assert not placed("a").excludes(placed("b"))


def test_consumers_of_an_exchanged_constant_learn_it_over_several_levels():  # R-A13
    living = [placed("last", ["M"]), placed("middle", ["N"], ["M"]), placed("old", (), ["N"]), placed("else", ["K"])]
    result = exchange(living, ["old"], [placed("new", (), ["N"])])
    assert result.reinit == ("middle", "last")


def test_who_lived_on_without_its_supplier_learns_the_constant_of_the_next_one():  # R-A13
    assert exchange([placed("user", ["N"])], [], [placed("new", (), ["N"])]).reinit == ("user",)


def test_a_newcomer_learns_again_what_a_kept_task_says_when_it_has_learnt():  # R-A13
    living = [placed("middle", ["N"], ["M"]), placed("old", (), ["N"])]
    result = exchange(living, ["old"], [placed("new", (), ["N"]), placed("last", ["M"]), placed("else", ["N"])])
    assert result.reinit == ("middle", "last")


def test_a_constant_that_goes_makes_nobody_learn_anything():  # R-A13
    assert exchange([placed("user", ["N"]), placed("old", (), ["N"])], ["old"], []).reinit == ()


CONSTANTS = [f"C{number}" for number in range(5)]


@st.composite
def placements(draw, prefix):
    """Tasks whose constants form no cycle: each reads what stands before what it writes."""
    tasks = []
    for number in range(draw(st.integers(0, 5))):
        level = draw(st.integers(0, 4))
        reads = draw(st.lists(st.sampled_from(CONSTANTS[:level] or ["X"]), unique=True, max_size=2))
        writes = draw(st.sampled_from([(), (CONSTANTS[level],)]))
        module = draw(st.sampled_from("abcdefgh"))
        device = draw(st.sampled_from([None, None, "w:one", "w:two"]))
        tasks.append(placed(f"{prefix}{number}", reads, writes, module, device))
    return tasks


@settings(max_examples=examples(200), deadline=None)
@given(placements("t"), placements("n"), st.data())
def test_an_exchange_says_of_everybody_what_happens(living, new, data):  # R-A13, reading 14
    gone = data.draw(st.sets(st.sampled_from([item.name for item in living]))) if living else set()
    result = exchange(living, gone, new)
    assert set(result.keep) | set(result.kill) == {item.name for item in living}
    assert set(result.kill) == gone
    again = {svar for item in (*living, *new) if item.name in result.reinit for svar in item.ports.outconst}
    assert all(again & set(item.ports.inconst) for item in new if item.name in result.reinit)
    assert set(result.reinit) <= set(result.keep) | set(result.spawn)
    assert sorted(result.spawn) == sorted(item.name for item in new)
    first = {item.name for item in living if item.name in gone and any(item.excludes(other) for other in new)}
    assert set(result.kill_first) == first
    by_name = {item.name: item.ports for item in (*living, *new)}
    for order in (result.spawn, result.reinit):
        for place, name in enumerate(order):
            later = {svar for other in order[place + 1 :] for svar in by_name[other].outconst}
            assert later.isdisjoint(by_name[name].inconst)


@settings(max_examples=examples(200), deadline=None)
@given(placements("t"), st.sets(st.sampled_from(CONSTANTS)))
def test_dependents_are_all_who_read_what_changes_and_nobody_else(tasks, constants):  # R-A13
    ports = [task.ports for task in tasks]
    result = dependents(ports, constants)
    changed = constants | {svar for port in ports if port.name in result for svar in port.outconst}
    assert set(result) == {port.name for port in ports if changed & set(port.inconst)}
