import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.icons.branches import conditions_of
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def test_flows_are_added_and_deleted_but_for_the_last(gallery):  # R-D04
    doc = gallery.begun("grip")
    assert gallery.do(act.AddFlow(doc)) == "1"
    gallery.add(doc, "open", flow="1")
    gallery.do(act.RemoveFlow(doc, "0"))
    assert gallery.flow(doc, "0") == "open"
    assert str(gallery.no(act.RemoveFlow(doc, "0")).reason) == "an application has at least one flow"
    assert "no longer there" in str(gallery.no(act.RemoveFlow(doc, "5")).reason)
    gallery.do(act.Undo(doc))
    assert (gallery.flow(doc, "0"), gallery.flow(doc, "1")) == ("grip", "open")


def test_an_application_is_made_parallel_or_conditional(gallery):  # R-D04, R-D20
    doc = gallery.begun(flows=2)
    gallery.do(act.SetParallel(doc, True))
    assert gallery.view(doc).is_parallel
    assert str(gallery.view(doc).undo) == "making it parallel"
    gallery.do(act.SetParallel(doc, True))
    gallery.do(act.Undo(doc))
    assert not gallery.view(doc).is_parallel


def test_the_conditions_of_a_branch_are_read_and_kept(gallery):  # R-D13
    doc = gallery.begun()
    branch = gallery.do(act.InsertBranch(doc, flows=3))
    gallery.do(act.SetConditions(doc, branch, ("LAMP == 1", "Q_MEZ[2] > 0.5")))
    assert gallery.view(doc).steps[str(branch)].conditions == ("LAMP == 1", "Q_MEZ[2] > 0.5")
    no = gallery.no(act.SetConditions(doc, branch, ("LAMP == 1", "dark")))
    assert list(no.fields) == ["conditions[1]"]
    assert "expected 2 conditions" in str(gallery.no(act.SetConditions(doc, branch, ("LAMP == 1",))).reason)
    assert "no branch" in str(gallery.no(act.SetConditions(doc, gallery.add(doc, "grip")[0], ())).reason)


def test_a_branch_that_chooses_by_conditions_is_not_given_a_flow_without_one(gallery):  # R-D13, R-X01
    doc = gallery.begun()
    branch = gallery.do(act.InsertBranch(doc, flows=2, conditions=("LAMP == 1",)))
    no = gallery.no(act.AddFlow(doc, branch))
    gallery.do(no.remedies[0].act)
    assert gallery.do(act.AddFlow(doc, branch)) == f"0/{branch}/2"


@pytest.mark.parametrize(("flow", "left"), [(0, ("B == 2",)), (1, ("A == 1",)), (2, ("A == 1",))])
def test_a_flow_goes_with_its_condition(gallery, flow, left):  # R-D13
    doc = gallery.begun()
    branch = gallery.do(act.InsertBranch(doc, flows=3, conditions=("A == 1", "B == 2")))
    gallery.do(act.RemoveFlow(doc, f"0/{branch}/{flow}"))
    assert gallery.view(doc).steps[str(branch)].conditions == left
    gallery.do(act.RemoveFlow(doc, f"0/{branch}/0"))
    no = gallery.no(act.RemoveFlow(doc, f"0/{branch}/0"))
    gallery.do(no.remedies[0].act)
    assert gallery.flow(doc) == ""


def test_there_are_as_many_conditions_as_flows_but_one():
    assert conditions_of((), 5) == ()
    assert conditions_of(("A==1",), 2) == ("A==1",)


def test_no_more_flows_than_anybody_can_mean(gallery):
    doc = gallery.begun(flows=32)
    assert "32 flows already" in str(gallery.no(act.AddFlow(doc)).reason)
    branch = gallery.do(act.InsertBranch(doc, flows=32))
    assert "32 flows already" in str(gallery.no(act.AddFlow(doc, branch)).reason)
