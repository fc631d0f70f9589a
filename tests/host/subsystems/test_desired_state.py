from onika.host.subsystems.desired_state import DesiredState


def wanted():
    desired = DesiredState()
    desired.turn_on("arm", "1 2")
    desired.set_rate("arm", 50.0)
    desired.state_constants("arm", {"NDOF": 6})
    desired.reinitialise_later("arm")
    return desired


def test_everything_about_a_task_is_forgotten_with_it():
    desired = wanted()
    desired.forget("arm")
    assert (desired.is_on("arm"), desired.line("arm"), desired.rate("arm")) == (False, "", None)
    assert desired.constants(["arm"]) == {}
    assert not desired.is_to_be_reinitialised("arm")


def test_what_was_before_can_be_taken_back_in_two_steps():  # law 22
    desired = wanted()
    before = desired.copy()
    desired.turn_everything_off()
    desired.set_rate("arm", 10.0)
    desired.state_constants("arm", None)
    desired.take_back_constants(before)
    assert (desired.constants(["arm", "other"]), desired.is_on("arm")) == ({"NDOF": 6}, False)
    desired.take_back(before)
    assert (desired.line("arm"), desired.rate("arm")) == ("1 2", 50.0)


def test_a_copy_does_not_follow():
    desired = wanted()
    before = desired.copy()
    desired.turn_off("arm")
    assert before.is_on("arm")
    assert before.constants_of("arm") == {"NDOF": 6}


def test_a_task_is_reinitialised_once():  # R-A13
    desired = wanted()
    desired.is_reinitialised("arm")
    assert not desired.is_to_be_reinitialised("arm")
