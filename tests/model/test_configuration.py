from onika.model.configuration import UNKNOWN_RTPU, Configuration, Placed


def test_a_task_that_was_never_spawned_is_on_an_unknown_rtpu() -> None:
    assert Placed("cubic").rtpu == UNKNOWN_RTPU == "unknown"  # decision 12


def test_two_configurations_of_the_same_content_are_equal() -> None:
    assert Configuration("a", (Placed("cubic"),)) == Configuration("a", (Placed("cubic"),))
    assert Configuration("a", (Placed("cubic", 1),)) != Configuration("a", (Placed("cubic"),))
