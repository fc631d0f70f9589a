import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.configuration import Group, Placed
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import ShowLibraries, ShowTask

TASKS = (
    Task("cubic", "cubic", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("trapez", "trapez", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", invar=("Q_REF", "Q_MEZ"), outvar=("TAU",), frequency=100.0),
    Task("robot", "robot", invar=("TAU",), outvar=("Q_MEZ",), frequency=100.0),
)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, TASKS)


def configuration(sitting, doc):
    return sitting.environment.model.documents[doc].content.configuration


def places(sitting, doc):
    return {placed.task: (placed.x, placed.y) for placed in configuration(sitting, doc).placed}


def test_tasks_are_copied_between_configurations_with_their_places_to_each_other(sitting):  # R-C10, R-C22
    first, other = sitting.new("cubic", "pd", "robot"), sitting.new()
    sitting.do(act.Copy(first, ("cubic", "pd")))
    assert sitting.environment.tree.clipboard == "cubic pd"
    assert sitting.do(act.Paste(other, 1000, 40)) == ("cubic", "pd")
    assert places(sitting, other) == {"cubic": (1000, 40), "pd": (1200, 40)}
    assert sorted(places(sitting, first)) == ["cubic", "pd", "robot"]


def test_loci_come_along_where_they_were_and_as_they_were_shown(sitting):  # R-C09, R-C24
    first, other = sitting.new("cubic", "pd"), sitting.new()
    sitting.do(act.Move(first, {}, {"Q_REF": (170, 20), "TAU": (900, 60)}))
    sitting.do(act.Show(first, ("TAU",), False))
    sitting.do(act.Copy(first, ("cubic", "pd")))
    sitting.do(act.Paste(other, 1000, 1000))
    loci = {locus.svar: locus for locus in configuration(sitting, other).loci}
    assert (loci["Q_REF"].x, loci["Q_REF"].y) == (1170, 920)
    assert (loci["TAU"].x, loci["TAU"].y, loci["TAU"].show) == (1900, 960, False)
    assert (loci["Q_REF"].invar, loci["Q_REF"].outvar) == (1, 1)


def test_loci_that_are_there_stay_and_those_that_come_keep_off_icons(sitting):  # R-C24
    first, other = sitting.new("cubic", "pd"), sitting.new("robot")
    sitting.do(act.Move(first, {}, {"TAU": (170, 120), "Q_REF": (30, 110)}))  # beneath what stands there below
    sitting.do(act.Copy(first, ("cubic", "pd")))
    sitting.do(act.Move(other, {"robot": (150, 100)}, {"Q_MEZ": (500, 5)}))
    sitting.do(act.Paste(other, 0, 400))
    loci = {locus.svar: (locus.x, locus.y) for locus in configuration(sitting, other).loci}
    assert loci["Q_MEZ"] != (500, 5), "the second task has come: it goes half-way"
    sitting.do(act.Undo(other))
    sitting.do(act.Move(other, {}, {"Q_MEZ": (500, 5), "TAU": (600, 5)}))
    sitting.do(act.Paste(other, 150, 100))
    boxes = sitting.environment.model.libraries.boxes(("robot", "cubic", "pd"))
    for locus in configuration(sitting, other).loci:
        for task in configuration(sitting, other).placed:
            inside_x = task.x < locus.x < task.x + boxes[task.task].width
            assert not (inside_x and task.y < locus.y < task.y + boxes[task.task].height), (locus, task)


def test_cut_is_one_step_and_leaves_what_was_cut_in_the_buffer(sitting):  # R-C10, R-X10
    doc = sitting.new("cubic", "pd")
    text = sitting.do(act.Cut(doc, ("pd",)))
    assert sorted(places(sitting, doc)) == ["cubic"]
    assert str(sitting.environment.tree.documents[doc].undo) == "cutting pd"
    sitting.do(act.Undo(doc))
    assert places(sitting, doc)["pd"] == (200, 100)
    sitting.do(act.Remove(doc, ("pd",)))
    assert sitting.do(act.Paste(doc, 5, 6)) == ("pd",)
    sitting.do(act.Undo(doc))
    assert sitting.do(act.Paste(doc, 5, 6, text)) == ("pd",)


def test_a_text_from_elsewhere_brings_rates_directions_and_units(sitting, tmp_path):  # R-C10
    elsewhere = EnvironmentFixture(tmp_path / "other", TASKS)
    theirs = elsewhere.new("pd")
    elsewhere.do(act.Flip(theirs, ("pd",)))
    text = elsewhere.do(act.Copy(theirs, ("pd",)))
    doc = sitting.new()
    sitting.do(act.Paste(doc, 1, 2, text))
    assert configuration(sitting, doc).placed == (Placed("pd", 1, 2, in_left=False),)


def test_nothing_is_pasted_where_one_task_may_not_be_and_every_reason_is_named(sitting):  # R-C07, R-X01
    doc = sitting.new("trapez", "pd", "robot")
    other = sitting.new("cubic", "pd")
    text = sitting.do(act.Copy(doc, ("trapez", "pd", "robot")))
    no = sitting.no(act.Paste(other, 0, 0, text))
    assert "trapez: writes Q_REF, which `cubic` already writes" in str(no.reason)
    assert "`pd` is placed already" in str(no.reason)
    assert "robot" not in str(no.reason)
    assert ShowTask("pd") in [remedy.show for remedy in no.remedies]
    assert not any(isinstance(remedy.act, act.Exchange) for remedy in no.remedies)


def test_the_only_task_that_is_pasted_may_replace_what_is_in_its_way(sitting):  # R-X01
    first, other = sitting.new("trapez"), sitting.new("cubic")
    sitting.do(act.Copy(first, ("trapez",)))
    (replace,) = [r.act for r in sitting.no(act.Paste(other, 0, 0)).remedies if isinstance(r.act, act.Exchange)]
    sitting.do(replace)
    assert sorted(places(sitting, other)) == ["trapez"]


def test_a_task_that_no_library_has_is_named(sitting, tmp_path):  # R-C10
    elsewhere = EnvironmentFixture(tmp_path / "other", (Task("grav", "grav", outvar=("G",), frequency=1.0),))
    theirs = elsewhere.new("grav")
    text = elsewhere.do(act.Copy(theirs, ("grav",)))
    no = sitting.no(act.Paste(sitting.new(), 0, 0, text))
    assert "grav: no open library has it" in str(no.reason)
    assert [remedy.show for remedy in no.remedies] == [ShowLibraries()]


def test_tasks_of_a_text_that_contradict_each_other_are_not_pasted(sitting):  # R-C07
    text = '{"onika":1,"tasks":[{"task":"cubic","x":0,"y":0},{"task":"trapez","x":0,"y":0}]}'
    assert "trapez: writes Q_REF, which `cubic` already writes" in str(
        sitting.no(act.Paste(sitting.new(), 0, 0, text)).reason
    )


def test_a_task_that_is_placed_and_in_no_library_is_placed_all_the_same(sitting):  # R-C10
    base = sitting.base
    (base.path / "conf").mkdir()
    text = "RMODFILE gone\nCOORDS 0 0\nEOF\n"
    base.configuration_file("old").write_text(text)
    doc = sitting.do(act.Open(str(base.configuration_file("old"))))
    copied = sitting.do(act.Copy(doc, ("gone",)))
    assert "gone is placed already" in str(sitting.no(act.Paste(doc, 0, 0, copied)).reason)


@pytest.mark.parametrize(
    ("wish", "reason"),
    [
        (act.Copy("c1", ()), "nothing is selected"),
        (act.Cut("c1", ("pd", "gone")), "there is no gone on the canvas"),
        (act.Copy("c9", ("pd",)), "no longer open"),
        (act.Cut("c9", ("pd",)), "no longer open"),
        (act.Paste("c9", 0, 0), "no longer open"),
        (act.Paste("c1", 0, 0), "nothing was copied yet"),
        (act.Paste("c1", 0, 0, "hello"), "found 'hello'"),
    ],
)
def test_what_cannot_be_copied_or_pasted_is_said(sitting, wish, reason):  # R-X01
    sitting.new("pd")
    assert reason in str(sitting.no(wish).reason)


def test_supermodules_come_along_under_a_name_that_is_free(sitting):  # R-C10, R-C17
    first, other = sitting.new("cubic", "pd", "robot"), sitting.new("robot")
    sitting.do(act.Group(first, "arm", ("pd", "cubic")))
    sitting.do(act.Group(other, "arm", ("robot",)))
    sitting.do(act.Cut(first, ("cubic", "pd")))
    assert configuration(sitting, first).groups == ()
    sitting.do(act.Paste(other, 0, 400))
    assert configuration(sitting, other).groups == (Group("arm", ("robot",)), Group("arm-2", ("pd", "cubic")))
    sitting.do(act.Paste(first, 0, 400))
    assert configuration(sitting, first).groups == (Group("arm", ("pd", "cubic")),)
