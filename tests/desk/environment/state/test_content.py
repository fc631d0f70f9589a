from dataclasses import replace

from onika.desk.environment.state.content import Content
from onika.model.configuration import Configuration, Group, Placed

TWO = Content(Configuration("c", (Placed("pd"), Placed("diff"))), {"pd": True, "diff": False})


def test_a_task_is_found_by_its_name():
    assert TWO.names == ("pd", "diff")
    assert TWO.placed("diff") == Placed("diff")
    assert TWO.placed("none") is None


def test_what_is_no_longer_placed_is_wanted_no_more():  # R-C11
    assert TWO.with_configuration(Configuration("c", (Placed("pd"),))).wanted == {"pd": True}


def test_what_is_no_longer_placed_is_in_no_supermodule():  # R-C17
    grouped = replace(TWO.configuration, groups=(Group("arm", ("diff", "pd")), Group("none", ("gone",))))
    kept = TWO.with_configuration(replace(grouped, placed=(Placed("pd"),)))
    assert kept.configuration.groups == (Group("arm", ("pd",)),)
