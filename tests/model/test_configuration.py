from onika.model.configuration import UNKNOWN_RTPU, Configuration, Group, Placed


def test_a_task_that_was_never_spawned_is_on_an_unknown_rtpu() -> None:
    assert Placed("cubic").rtpu == UNKNOWN_RTPU == "unknown"  # reading 12


def test_two_configurations_of_the_same_content_are_equal() -> None:
    assert Configuration("a", (Placed("cubic"),)) == Configuration("a", (Placed("cubic"),))
    assert Configuration("a", (Placed("cubic", 1),)) != Configuration("a", (Placed("cubic"),))


ABC = Configuration("c", (Placed("a"), Placed("b"), Placed("c")))


def test_a_supermodule_has_tasks_that_are_placed_and_is_gone_without_any() -> None:
    groups = (Group("one", ("b", "gone", "a")), Group("two", ("a", "c")), Group("three", ("gone",)))
    assert ABC.regrouped(groups).groups == (Group("one", ("b", "a")), Group("two", ("c",)))  # R-C17
    assert ABC.regrouped(()) is ABC
    assert ABC.regrouped(groups).group("two") == Group("two", ("c",))
    assert ABC.group("two") is None


def test_the_tasks_of_a_supermodule_come_in_its_order_at_the_places_they_have() -> None:
    grouped = ABC.regrouped([Group("one", ("c", "a"))])
    assert grouped.in_group_order(["a", "x", "b", "c"]) == ["c", "x", "b", "a"]  # R-C17
    assert grouped.in_group_order(["a", "b"]) == ["a", "b"]


def test_where_tasks_stand_is_no_part_of_what_a_configuration_means() -> None:
    here, there = (Configuration("c", (Placed("pd", x), Placed("puma"))) for x in (0, 90))
    assert (here.meaning == there.meaning, here == there) == (True, False)
    assert here.meaning != Configuration("c", (Placed("pd", frequency=100.0), Placed("puma"))).meaning
    assert here.names == ("pd", "puma")
