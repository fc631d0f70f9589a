import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.icons import repetition
from onika.desk.environment.initial_model import opened
from onika.model.application import Icon
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.wire import act


class Beginner(EnvironmentFixture):
    """Somebody with what is shipped, and an application of a few actions."""

    def __init__(self, folder, dictionaries=()):
        model, _ = opened(open_site([], {}, folder), None, {}, dictionaries)
        super().__init__(folder, (), model)

    def begun(self, *icons):
        self.doc = self.do(act.NewApplication(1))
        self.numbers = []
        for name in icons:
            self.numbers.append(self.do(act.InsertIcon(self.doc, name, "0", self.numbers[-1] if self.numbers else 0)))
        return self.numbers

    @property
    def steps(self):
        return self.environment.model.applications[self.doc].application.flows[0].steps

    @property
    def words(self):
        marks = ((step.onikon.name, step.while_tag, step.while_test) for step in self.steps if isinstance(step, Icon))
        return [f"{name}{f' {tag}' if tag else ''}{'!' * test}" for name, tag, test in marks]


@pytest.fixture
def me(tmp_path):
    return Beginner(tmp_path)


def test_what_is_selected_is_repeated_so_many_times_as_one_step(me):  # R-D13, R-D06
    first, _, last = me.begun("opengripC", "closegripC", "opengripC")
    assert me.do(act.RepeatSteps(me.doc, (first, last), 3)) == "A"
    assert me.words == ["opengripC A", "closegripC", "opengripC", "repeatC A!", "three"]
    me.do(act.Undo(me.doc))
    assert me.words == ["opengripC", "closegripC", "opengripC"]


def test_a_number_that_no_dictionary_has_gets_an_icon_of_its_own(me):
    (only,) = me.begun("opengripC")
    me.do(act.RepeatSteps(me.doc, (only,), 7, "7 times"))
    number = me.steps[-1].onikon
    assert (number.values, number.description, number.type) == (((7,),), "7 times", "Number object")


def test_an_action_with_its_target_is_repeated_whole(me):
    job, _ = me.begun("jmoveC", "home")
    me.do(act.RepeatSteps(me.doc, (job,), 10))
    assert me.words == ["jmoveC A", "home", "repeatC A!", "ten"]


def test_what_begins_with_an_end_of_a_loop_is_repeated_from_a_no_op_before_it(me):  # R-D13, R-D11, reading 23
    first, last = me.begun("opengripC", "closegripC")
    me.do(act.RepeatSteps(me.doc, (first, last), 2))
    assert me.do(act.RepeatSteps(me.doc, (first, last, *(step.number for step in me.steps[2:])), 3)) == "B"
    assert me.words == ["noop B", "opengripC A", "closegripC", "repeatC A!", "times_2", "repeatC B!", "three"]
    me.do(act.Undo(me.doc))
    assert me.words == ["opengripC A", "closegripC", "repeatC A!", "times_2"]


def test_loops_lie_within_each_other_or_are_refused(me):  # reading 23, R-X01
    first, second, last = me.begun("opengripC", "closegripC", "opengripC")
    me.do(act.RepeatSteps(me.doc, (first, second), 2))
    no = me.no(act.RepeatSteps(me.doc, (second, last), 3))
    assert no.reason.key == "desk.loop_crosses"
    assert me.do(act.RepeatSteps(me.doc, (last,), 3)) == "B"


def test_without_a_no_op_an_action_is_no_end_of_two_loops(me, monkeypatch):  # R-X01
    (only,) = me.begun("opengripC")
    me.do(act.RepeatSteps(me.doc, (only,), 2))
    monkeypatch.setattr(repetition, "_noop", lambda _model: None)
    no = me.no(act.RepeatSteps(me.doc, (only,), 3))
    assert "end of the loop A already" in str(no.reason) and no.remedies


def test_where_no_open_dictionary_has_a_job_that_counts_the_one_that_has_is_offered(tmp_path):  # R-D13, R-X01
    me = Beginner(tmp_path, [shipped() / "boxes", shipped() / "puma"])
    (only,) = me.begun("opengripC")
    no = me.no(act.RepeatSteps(me.doc, (only,), 3))
    assert [str(remedy.label) for remedy in no.remedies] == ["Open the dictionary generic"]
    me.do(no.remedies[0].act)
    me.do(act.RepeatSteps(me.doc, (only,), 3))
    assert me.words == ["opengripC A", "repeatC A!", "three"]


@pytest.mark.parametrize("times", [-1, 0, 1, 1_000_001])
def test_what_is_no_number_of_times_is_refused(me, times):  # R-X01
    me.begun("opengripC")
    assert "times" in me.no(act.RepeatSteps(me.doc, tuple(me.numbers), times)).fields
    assert me.words == ["opengripC"]


def test_what_is_gone_or_no_action_begins_no_loop(me):  # R-X01
    me.begun("opengripC")
    assert me.no(act.RepeatSteps(me.doc, (99,), 3)).reason
    branch = me.do(act.InsertBranch(me.doc, "0", 0, 2))
    assert me.no(act.RepeatSteps(me.doc, (branch,), 3)).reason
