"""Faults stand behind those from which they follow."""

from onika.words.cause import by_cause, causes_first
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

MODEL, ROBOT, WORLD, TASK = Place("arm.xml", 11), Place("arm.robot", 3), Place("hall.world", 8), Place("arm.rmod")


def fault(place, *because, what="wrong"):
    return Fault(place, Reason.plain(what), Reason.plain("left out"), because=because)


def told(faults):
    return [(cause.fault.place, [each.place for each in cause.consequences]) for cause in by_cause(faults)]


def test_what_follows_from_a_fault_over_several_others_stands_behind_it():  # R-B07
    chain = [fault(TASK, WORLD), fault(WORLD, ROBOT), fault(ROBOT, MODEL), fault(MODEL)]
    assert told(chain) == [(MODEL, [TASK, WORLD, ROBOT])]
    assert [each.place for each in causes_first(chain)] == [MODEL, TASK, WORLD, ROBOT]


def test_causes_with_consequences_come_before_faults_that_stand_alone():  # R-B07
    alone = fault(Place("a.conf", 1))
    assert told([alone, fault(TASK, MODEL), fault(MODEL)]) == [(MODEL, [TASK]), (alone.place, [])]


def test_a_fault_whose_cause_is_not_there_is_one_by_itself():  # R-B07
    assert told([fault(TASK, WORLD)]) == [(TASK, [])]


def test_each_fault_is_there_once_and_what_has_two_causes_stands_behind_the_first():  # R-B07
    twice = fault(TASK, ROBOT, WORLD)
    assert told([fault(ROBOT), fault(WORLD), twice, twice]) == [(ROBOT, [TASK]), (WORLD, [])]


def test_a_second_fault_of_the_same_place_may_follow_from_the_first():  # R-B07
    assert told([fault(WORLD, what="no such file"), fault(WORLD, WORLD, what="no model")]) == [(WORLD, [WORLD])]


def test_faults_that_name_each_other_are_all_there():  # R-B07
    circle = [fault(TASK, WORLD), fault(WORLD, TASK)]
    assert sorted(each.place for each in causes_first(circle)) == [TASK, WORLD]
