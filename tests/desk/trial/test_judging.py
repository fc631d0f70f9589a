from dataclasses import replace

import pytest

from onika.desk.trial.judging import judge
from onika.model.kept import Demand, KeptMeeting
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

WAY = ("open", "move above", "move down", "close", "move above", "move aside", "move stack", "open", "move aside")


def judged(kept, account):
    """The verdict in English."""
    verdict = judge(kept, account)
    return replace(verdict, failures=tuple(map(str, verdict.failures)), notes=tuple(map(str, verdict.notes)))


def way(at, *new, gone=1):
    return (*WAY[:at], *new, *WAY[at + gone :])


def test_the_same_run_is_passed_and_so_is_one_that_differs_within_tolerances(workshop):  # R-X07
    kept = workshop.kept().kept
    assert judged(kept, workshop.run()).failures == ()
    assert judged(kept, workshop.run(off=0.004, force=1.0, seconds=1.04)).is_passed


@pytest.mark.parametrize(
    ("mistake", "words"),
    [
        (way(2, "move elsewhere"), "Q_MEZ after action 3 (move down)"),
        (way(0), "expected action 1 (open), found it missing"),
        (way(3), "expected action 4 (close), found it missing"),
        (way(7), "expected action 8 (open), found it missing"),
        (way(2, WAY[3], WAY[2], gone=2), "expected nothing more here"),
        (way(1, WAY[1], WAY[1]), "expected nothing more here"),
        (way(3, "close", "close"), "expected nothing more here"),
        (way(8), "expected action 9 (move aside), found it missing"),
        (way(4, "grip above"), "expected nothing more here, found action 5 (grip above)"),
    ],
)
def test_mistakes_in_a_program_are_caught(workshop, mistake, words):  # R-X07
    verdict = judged(workshop.kept().kept, workshop.run(mistake))
    assert not verdict.is_passed
    assert any(words in failure for failure in verdict.failures), verdict.failures


def test_a_lift_that_is_left_out_changes_nothing_and_is_told(workshop):  # R-X07
    verdict = judged(workshop.kept().kept, workshop.run(way(4)))
    assert verdict.failures == ()
    assert any("action 5 (move above) is left out" in note for note in verdict.notes)


def test_a_person_may_forbid_what_was_on_the_way_to_be_left_out(workshop):  # R-X07
    kept = workshop.kept().kept
    actions = tuple(replace(action, is_on_way=False) for action in kept.flows[0].actions)
    strict = replace(kept, flows=(replace(kept.flows[0], actions=actions),))
    assert not judged(strict, workshop.run(way(4))).is_passed


def test_a_lift_that_is_left_out_and_does_change_something_is_caught(workshop):  # R-X07
    account = workshop.run(way(4))
    account.parts[0].at_end["LAMP"] = (0.0,)
    assert judged(workshop.kept().kept, account).failures == ("flow0: LAMP at the end: expected 1, found 0",)


def test_another_name_for_the_same_target_is_only_told(workshop):  # R-X07
    account = workshop.run()
    account.parts[0].passed[1].name = "move over_it"
    verdict = judged(workshop.kept().kept, account)
    assert verdict.is_passed
    assert verdict.notes == ("flow0: action 2 (move above) is move over_it now; what it does is judged",)


def test_a_duration_is_judged_but_not_where_the_way_is_another(workshop):  # R-X07
    kept, account = workshop.kept().kept, workshop.run(way(4))
    account.parts[0].passed[4].ended_s += 0.5
    assert judged(kept, account).is_passed
    account.parts[0].passed[5].ended_s += 0.5
    assert judged(kept, account).failures == ("flow0: action 7 (move stack): expected to last 1 ± 0.05 s, found 1.5 s",)


def test_a_variable_is_told_once_with_since_when_it_is_wrong(workshop):  # R-X07
    verdict = judged(workshop.kept().kept, workshop.run(off=0.01))
    assert verdict.failures[0] == (
        "flow0: Q_MEZ after action 2 (move above) at 1.18 s: expected 0.5 ± 0.005, found 0.51 rad"
        "; since then wrong 6 times more, last at the end"
    )
    assert len([failure for failure in verdict.failures if "Q_MEZ" in failure]) == 1


def test_the_element_that_is_wrong_is_named(workshop):  # R-X07
    kept, account = workshop.kept().kept, workshop.run()
    kept = replace(kept, flows=(replace(kept.flows[0], at_end=(Demand("Q_MEZ", (1.0, 2.0, 3.0), "rad", 0.1),)),))
    account.parts[0].at_end["Q_MEZ"] = (1.0, 2.5, 9.0)
    (wrong,) = judged(kept, account).failures
    assert wrong == "flow0: Q_MEZ[1] at the end: expected 2 ± 0.1, found 2.5 rad, and 1 more element"


@pytest.mark.parametrize(
    ("demand", "failure"),
    [
        (Demand("NOISE", (1.0,)), "found none: no task that is on writes it"),
        (Demand("Q_MEZ", (-0.7,), "deg", 1.0), "expected it in deg, found it in rad"),
        (Demand("Q_MEZ", (-0.7, 1.0), "rad", 1.0), "expected 2 numbers, found 1"),
    ],
)
def test_a_demand_that_cannot_be_met_says_why(workshop, demand, failure):  # R-X07
    kept = workshop.kept().kept
    kept = replace(kept, flows=(replace(kept.flows[0], at_end=(demand,)),))
    assert failure in judged(kept, workshop.run()).failures[0]


def test_what_is_no_number_never_holds(workshop):  # R-X07
    account = workshop.run()
    account.parts[0].at_end["Q_MEZ"] = (float("nan"),)
    assert "found nan rad" in judged(workshop.kept().kept, account).failures[0]


def test_another_robot_and_another_flow_are_caught(workshop):  # R-X07
    (wrong,) = judged(workshop.kept().kept, workshop.run(robot="puma_right")).failures
    assert wrong == "flow0: expected the robots puma on boxes:arm; found puma_right on boxes:arm"
    account = workshop.run()
    account.parts[0].subsystem = "flow7"
    failures = judged(workshop.kept().kept, account).failures
    assert failures == (
        "flow0: expected a flow of 9 actions, found none",
        "flow7: expected no such flow, found 9 actions",
    )


def test_flows_that_meet_elsewhere_are_caught(workshop):  # R-X07
    assert judged(workshop.kept().kept, workshop.run(tag="later")).failures == (
        "meetings: expected meet of flow0 and flow1; found later of flow0 and flow1",
    )
    account = workshop.run()
    account.meetings = [KeptMeeting("meet", ("flow1", "flow0"))]
    assert judged(workshop.kept().kept, account).is_passed


def test_a_run_that_is_refused_or_aborted_says_why_and_how_far_it_came(workshop):  # R-X07
    kept = workshop.kept().kept
    fault = Fault(Place("a.appl", 3), Reason.plain("expected one, found two"), Reason.plain("it is not run"))
    assert judged(kept, workshop.run(refusals=(fault,) * 9)).failures == (
        *(f"it is refused: {fault}",) * 5,
        "and for 4 more reasons: see onika check",
    )
    verdict = judged(
        kept, workshop.run(WAY[:3], cause="the arm tripped", warnings=[Reason.plain("flow0, puma: too hot")] * 2)
    )
    assert verdict.failures == (
        "it does not come to its end: the arm tripped",
        "before that: flow0, puma: too hot",
        "flow0: 6 actions are not done, from action 4 (close) on",
    )


def test_expectations_and_a_changed_application_are_told(workshop):  # R-X07
    account = workshop.run(expectations=[("LAMP == 0", 1, False), ("LAMP > 0", 1, True)], digest="new")
    verdict = judged(workshop.kept().kept, account)
    assert verdict.failures == ("at the end: expected LAMP == 0, found 1",)
    assert verdict.notes == ("the application is no more what it was when the run was kept (d, now new)",)
