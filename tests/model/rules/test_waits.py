"""Who can come to wait for whom for ever, beside a plain search that moves one flow at a time (R-X03, reading 26)."""

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.plans.program_tree import Act, Loop, Pick, Side, planned
from onika.model.rules.waits import FlowWait, Waits
from onika.wire.plan import Again, Choose, Fork, Halt, Join, Jump, Meet, Unless

NOOP = Act(tasks=(), is_noop=True)


def explored(*trees, limit=100_000):
    """What is found among all flows together."""
    waits = Waits(planned(*trees).flows)
    return waits.explore(sum(waits.families(), ()), limit)


def tags(text):
    return tuple(Act("" if part == "-" else part) for part in text.split())


def test_two_flows_that_meet_in_one_order_get_through():
    result = explored(tags("a - b"), tags("- a b"))
    assert (result.deadlocks, result.is_whole) == ((), True)


def test_a_circle_is_told_once_from_its_first_flow():
    result = explored(tags("a b"), tags("b c"), tags("c a"))
    assert result.is_certain
    assert [deadlock.waits for deadlock in result.deadlocks] == [
        (FlowWait(0, 0, 2), FlowWait(2, 0, 1), FlowWait(1, 0, 0))
    ]


def test_a_flow_that_waits_for_an_ended_one_waits_for_ever():
    result = explored(tags("a a"), tags("a"))
    assert [(deadlock.waits, deadlock.is_circle) for deadlock in result.deadlocks] == [((FlowWait(0, 2, 1),), False)]


def test_who_waits_for_a_flow_in_a_circle_is_no_circle_of_its_own():
    result = explored(tags("a"), tags("b a"), tags("c b"), tags("b c"))
    assert [{wait.flow for wait in deadlock.waits} for deadlock in result.deadlocks] == [{2, 3}]


def test_a_deadlock_beside_flows_that_go_on_for_ever_is_found():
    for_ever = (Loop("l", (Act("z"), NOOP)),)
    result = explored(tags("a b"), tags("b a"), for_ever, for_ever)
    assert [{wait.flow for wait in deadlock.waits} for deadlock in result.deadlocks] == [{0, 1}]


def test_waiting_for_a_flow_that_goes_round_for_ever_is_told_apart():
    result = explored(tags("a"), (Loop("l", (Act(), NOOP)), Act("a")))
    assert (result.deadlocks, result.idling) == ((), (FlowWait(0, 0, 1),))


def test_a_tag_that_a_nested_flow_does_not_come_to_again_ties_its_parent_up():  # R-D13
    result = explored((Side(((Act("n a"), Act("n a")), (Act("n a"),))),))
    assert [deadlock.waits for deadlock in result.deadlocks] == [(FlowWait(0, 3, 1), FlowWait(1, -1, 0))]
    assert result.is_certain


def test_a_nested_application_in_a_loop_begins_anew_each_time():
    result = explored((Loop("l", (Side(((Act("n a"),), (Act("n a"), Act()))), Act())),))
    assert (result.deadlocks, result.is_whole) == ((), True)


def test_what_has_nothing_to_do_with_each_other_is_looked_at_apart():
    waits = Waits(planned(tags("a"), tags("b"), tags("a"), tags("b"), (Side(((), ())),)).flows)
    assert waits.families() == [(0, 2), (1, 3), (4, 5)]


def test_the_example_names_the_choices_on_the_way():
    result = explored((Act(), Pick((tags("a"), tags("b")))), tags("a b"))
    choices = {
        deadlock.is_circle: [(flow, choice.args["number"]) for flow, choice in deadlock.choices]
        for deadlock in result.deadlocks
    }
    assert choices == {True: [(0, 1)], False: [(0, 0)]}


def test_a_run_that_can_go_on_for_ever_is_no_certain_deadlock():
    result = explored((Loop("l", (Act("a"), Act())), Act("b")), (Loop("l", (Act("a"), NOOP)), Act("b")))
    assert result.deadlocks
    assert not result.is_certain


def test_too_much_to_look_at_is_said():
    several = (Act(), Pick((tags("a b c"), tags("a b c"), tags("a b c"))))
    assert not explored(several, several, several, limit=5).is_whole
    assert explored(several, several, several).is_whole


def test_straight_flows_are_looked_at_once_for_each_meeting():  # linear: so many states, whatever the order
    count = 400
    flows = [tags(" ".join(f"t{number}" for number in range(count)))] * 16
    assert explored(*flows).states == count + 1


# The same by a plain search


def nodes(names):
    acts = st.builds(Act, st.sampled_from(names))
    return st.recursive(
        acts,
        lambda inner: st.one_of(
            st.builds(lambda body, is_top: Loop("l", body, is_top), seq(inner, acts), st.booleans()),
            st.builds(lambda item, two: Pick((tuple(item), tuple(two))), *[st.lists(inner, max_size=2)] * 2),
        ),
        max_leaves=3,
    )


def seq(inner, acts):
    return st.tuples(acts, inner, acts)


def trees(names=("", "a", "b")):
    return st.lists(nodes(names), max_size=3).map(tuple)


def nested(names=("n x", "n y", "")):
    return st.tuples(trees(names), trees(names)).map(lambda flows: (Side(flows),))


class Search:
    """All states, one flow moved at a time: (place, whether there is a value) of each, visits of each tag by each."""

    def __init__(self, plan):
        self.flows = [flow.program for flow in plan.flows]
        self.parents = [flow.parent for flow in plan.flows]
        self.tags = sorted({part.tag for program in self.flows for part in program if isinstance(part, Meet)})
        self.parties = {tag: [n for n, program in enumerate(self.flows) if Meet(tag) in program] for tag in self.tags}
        places = tuple((0, False) if parent is None else None for parent in self.parents)
        self.first = (places, tuple((0,) * len(self.flows) for _ in self.tags), (False,) * len(self.flows))
        self.after = {}
        ahead = [self.first]
        while ahead:
            state = ahead.pop()
            if state not in self.after:
                self.after[state] = list(self.moves(state))
                ahead += [new for _, new in self.after[state]]

    def moves(self, state):
        places, visits, waiting = state
        for number, where in enumerate(places):
            if where is None:
                continue
            at, has_value = where
            item = self.flows[number][at]
            match item:
                case Meet() if not waiting[number]:
                    yield number, self.visited(state, number, item.tag)
                case Meet():
                    counts = visits[self.tags.index(item.tag)]
                    if all(counts[other] >= counts[number] for other in self.parties[item.tag]):
                        yield number, self.at(state, number, at + 1, has_value)
                case Choose():
                    for to in item.to if has_value else item.to[:1]:
                        yield number, self.at(state, number, to, has_value)
                case Again() | Unless():
                    stay, leave = (item.to, at + 1) if isinstance(item, Again) else (at + 1, item.to)
                    for to in (stay, leave) if has_value else (leave,):
                        yield number, self.at(state, number, to, has_value)
                case Jump():
                    yield number, self.at(state, number, item.to, has_value)
                case Fork():
                    new = self.at(state, number, at + 1, has_value)
                    for child, place in item.flows:
                        new = self.at(new, child, place, False)
                    yield number, new
                case Join():
                    if all(places[child] is None for child in item.flows):
                        yield number, self.at(state, number, at + 1, has_value)
                case Halt():
                    yield number, self.at(state, number, None, False)
                case _:
                    yield number, self.at(state, number, at + 1, True)

    def at(self, state, number, place, has_value):
        places, visits, waiting = state
        new = None if place is None else (place, has_value)
        return (
            (*places[:number], new, *places[number + 1 :]),
            visits,
            (*waiting[:number], False, *waiting[number + 1 :]),
        )

    def visited(self, state, number, tag):
        places, visits, waiting = state
        at = self.tags.index(tag)
        counts = [count + (item == number) for item, count in enumerate(visits[at])]
        least = min(counts[party] for party in self.parties[tag])
        counts = tuple(count - least if item in self.parties[tag] else 0 for item, count in enumerate(counts))
        return (
            places,
            (*visits[:at], counts, *visits[at + 1 :]),
            (*waiting[:number], True, *waiting[number + 1 :]),
        )

    def can_be_completed(self):
        return any(all(place is None for place in places) for places, _, _ in self.after)

    def can_stand_still(self):
        return any(not moves and any(places) for (places, _, _), moves in self.after.items())


def judged(plan):
    waits = Waits(plan.flows)
    return [waits.explore(family, 100_000) for family in waits.families()]


@settings(max_examples=examples(150), deadline=None)
@given(
    st.one_of(
        st.tuples(trees(), trees()),
        st.tuples(trees(), trees(("", "a", "c")), trees(("b", "c"))),
        nested().map(lambda item: (item,)),
    )
)
def test_what_can_stand_still_is_foretold_and_nothing_else(flows):
    plan = planned(*flows)
    result, search = judged(plan), Search(plan)
    assert any(item.deadlocks for item in result) == search.can_stand_still()
    if any(item.is_certain for item in result):
        assert not search.can_be_completed()
    elif not any(item.deadlocks for item in result):
        assert search.can_be_completed()


straight = st.lists(st.sampled_from(["", "a", "b", "c"]).map(Act), max_size=6).map(tuple)


@settings(max_examples=examples(150), deadline=None)
@given(st.lists(straight, min_size=2, max_size=3))
def test_straight_flows_either_get_through_or_certainly_do_not(flows):
    plan = planned(*flows)
    result = judged(plan)
    assert all(item.is_certain == bool(item.deadlocks) for item in result)
    assert any(item.is_certain for item in result) != Search(plan).can_be_completed()
