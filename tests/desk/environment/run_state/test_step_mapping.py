import pytest
from msgspec import structs

from kit.record.recording_builder import run
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.messages import IconWording
from onika.desk.environment.run_state.step_mapping import CurrentApplication, recast
from onika.wire.plan import Plan, PlannedAction, PlannedFlow
from onika.words.reason import Reason


def plan(*flows, spots=False):
    """Of flows of actions, each a letter; now they have spots of their own."""
    number = iter(range(1, 99))

    def action(name):
        return PlannedAction(name, name, None, "p.appl", (), (), "", spot=(next(number),) if spots else (77,))

    return Plan("p", tuple(PlannedFlow(f"flow{n}", (), tuple(map(action, flow))) for n, flow in enumerate(flows)), ())


def recast_on(recorded, now):
    present = CurrentApplication("a1", "p", now, StepMembership({}, {}), IconWording())
    return recast(recorded, present)


def spots(made):
    return ["".join(str(action.spot[0]) if action.spot else "." for action in flow.actions) for flow in made.plan.flows]


@pytest.mark.parametrize(
    ("then", "now", "expected"),
    [
        (["abc"], ["abc"], ["123"]),
        (["aaba"], ["aaba"], ["1234"]),
        (["abc"], ["ac"], ["1.2"]),
        (["abc"], ["abxc"], ["124"]),
        (["abc"], ["xyz"], ["..."]),
        (["ab", "cd"], ["cd", "ab"], ["34", "12"]),
        (["ab", "ab"], ["ab", "ab"], ["12", "34"]),
        (["ab", "cd"], ["cd"], ["..", "12"]),
        (["abcd"], ["xx", "abd"], ["34.5"]),
    ],
)
def test_actions_are_found_again_by_their_names(then, now, expected):  # R-X05
    assert spots(recast_on(plan(*then), plan(*now, spots=True))) == expected


def test_what_is_as_it_was_needs_no_word():
    assert recast_on(plan("abc"), plan("abc", spots=True)).notes == ()


def test_what_has_changed_since_is_told():  # R-X05: icons that are others now
    (lost,) = recast_on(plan("abcde"), plan("a", spots=True)).notes
    assert str(lost) == "p has changed since it was recorded: 4 of 5 recorded actions have no icon now: b, c, d, …"
    (more,) = recast_on(plan("ab"), plan("abc", spots=True)).notes
    assert str(more) == "p has changed since it was recorded: 1 action of it now was not there"
    (broken,) = recast_on(plan("ab"), None).notes
    assert broken.key == "run.not_compiled"


def test_without_an_application_there_are_no_steps():
    made = recast(plan("ab"), None)
    assert (spots(made), made.doc, made.notes) == ([".."], "", ())


def test_a_redirection_of_that_run_is_told():  # R-E09, R-X05
    servo = run().prepare.plan.flows[0].tasks[0]
    flow = structs.replace(plan("a").flows[0], replaced=(("other", servo),))
    assert recast(Plan("p", (flow,), ()), None).notes == (Reason.of("run.stood_for", name="other", old="mass"),)
    (note,) = recast(Plan("p", (plan("b").flows[0], flow), ()), None).notes
    assert str(note) == "other stood for mass in flow 1"
