import pytest

from onika.model.application import AppFlow, Application, Branch, Hole, Icon
from onika.model.flow_path import flows_by_path, numbered, spot_of, spots, unnumbered, with_flows, with_step
from onika.model.onikon import Onikon
from onika.model.picture import blank


def icon(name):
    return Icon(Onikon(name, "Complete job", "", (), blank()))


GRIP, OPEN = icon("grip"), icon("open")
NESTED = Application(
    "a", False, (AppFlow((GRIP,)), AppFlow((OPEN, Branch((AppFlow((GRIP, Hole())), AppFlow(()))), GRIP)))
)


def test_every_step_gets_one_number_and_keeps_it():  # R-D05
    application, last = numbered(NESTED, 10)
    assert sorted(spots(application)) == list(range(11, 17))
    assert last == 16
    assert numbered(application, last) == (application, last)
    assert numbered(application, last)[0] is application
    assert application == NESTED, "numbers are no part of what it says"


def test_a_flow_is_named_by_its_path_through_branches():  # R-D13
    application, _ = numbered(NESTED, 0)
    branch = next(number for number, spot in spots(application).items() if isinstance(spot.step, Branch))
    assert [path for path, _ in flows_by_path(application)] == ["0", "1", f"1/{branch}/0", f"1/{branch}/1"]
    assert spots(application)[branch][:2] == ("1", 1)
    assert {number: spot_of(application, number) for number in spots(application)} == spots(application)
    assert spot_of(application, 99) is None


def test_another_flow_takes_the_place_of_one_deep_inside_and_the_rest_is_the_same():  # R-D13
    application, _ = numbered(NESTED, 0)
    branch = next(number for number, spot in spots(application).items() if isinstance(spot.step, Branch))
    changed = with_flows(application, {f"1/{branch}/1": AppFlow((OPEN,)), "0": AppFlow(())})
    assert dict(flows_by_path(changed))[f"1/{branch}/1"].steps == (OPEN,)
    assert changed.flows[0].steps == ()
    assert changed.flows[1].steps[0] is application.flows[1].steps[0]
    with pytest.raises(ValueError, match="no branch"):
        with_flows(application, {f"1/{application.flows[1].steps[0].number}/0": AppFlow(())})


def test_one_step_is_exchanged_by_its_number():
    application, _ = numbered(NESTED, 0)
    number = application.flows[0].steps[0].number
    assert with_step(application, number, OPEN).flows[0].steps == (OPEN,)
    with pytest.raises(KeyError):
        with_step(application, 99, OPEN)


def test_what_is_copied_has_no_numbers_at_any_depth():  # R-D05
    application, _ = numbered(NESTED, 0)
    steps = unnumbered(application.flows[1].steps)
    bare = Application("a", False, (AppFlow(steps),))
    assert {spot.step.number for _, spot in spots(bare).items()} == {0}
