from onika.host.subsystems.outcomes import Outcomes
from onika.model.lifecycle import State
from onika.words.reason import Reason


def test_who_came_and_went_since_it_was_told_is_remembered():  # law 22
    outcomes = Outcomes()
    outcomes.expect_switch(["old"], ["quick"])
    outcomes.turn("quick", State.ON)
    outcomes.turn("quick", State.OFF)
    outcomes.turn("old", State.OFF)
    assert outcomes.has_come("quick")
    assert outcomes.has_gone("old")
    outcomes.expect_switch(["old"], ["quick"])
    assert not outcomes.has_come("quick")
    assert not outcomes.has_gone("old")


def test_a_new_command_needs_a_new_answer_and_excuses_what_was():
    outcomes = Outcomes()
    outcomes.answer("arm")
    outcomes.fail("arm", Reason.plain("reinit: too many"))
    outcomes.expect_answer("arm")
    assert not outcomes.has_answered("arm")
    assert not outcomes.has_trouble("arm")


def test_what_went_wrong_is_one_sentence_that_names_each_task_once():
    outcomes = Outcomes()
    outcomes.fail_all({"arm": Reason.plain("on: no"), "hand": Reason.plain("spawn: no")})
    assert str(outcomes.trouble(["hand", "arm", "hand", "other"])) == "hand: spawn: no; arm: on: no"
    outcomes.begin()
    assert not outcomes.trouble(["hand", "arm"])
