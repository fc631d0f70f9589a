import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.labs.laboratory import Laboratory
from onika.files import conf
from onika.model.configuration import Group
from onika.model.rules.order import Ports
from onika.model.rules.reconfiguration import PlacedTask as Standing, exchange
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import GroupView, ShowTask

TASKS = (
    Task("cubic", "cubic", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("trapez", "trapez", invar=("Q_MEZ",), outvar=("Q_REF",), frequency=100.0),
    Task("pd", "pd", inconst=("KP",), invar=("Q_REF", "Q_MEZ"), outvar=("TAU",), frequency=100.0),
    Task("robot", "robot", outconst=("KP",), invar=("TAU",), outvar=("Q_MEZ",), frequency=100.0),
    Task("grav", "grav", outvar=("G",), frequency=100.0),
)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, TASKS)


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS)


def groups(desk, doc="c1"):
    return {name: group.tasks for name, group in desk.environment.tree.documents[doc].groups.items()}


def spots(desk, doc="c1"):
    return {name: (task.x, task.y) for name, task in desk.environment.tree.documents[doc].tasks.items()}


def remedies(no):
    return {str(remedy.label): remedy.act or remedy.show for remedy in no.remedies}


# -- grouping and expanding


def test_tasks_are_one_under_a_name_until_they_are_expanded(sitting):  # R-C17
    doc = sitting.new("robot", "grav", "pd")
    sitting.do(act.Group(doc, "arm", ("grav", "robot")))
    assert sitting.environment.tree.documents[doc].groups == {"arm": GroupView(("grav", "robot"))}
    sitting.do(act.Ungroup(doc, "arm"))
    assert groups(sitting) == {} and len(spots(sitting)) == 3


def test_grouping_is_a_step_and_a_change_to_be_saved(sitting):  # R-C17, R-X10, R-C06
    doc = sitting.new("robot", "grav")
    sitting.do(act.Save(doc, "move", str(sitting.base.path)))
    sitting.do(act.Group(doc, "arm", ("grav", "robot")))
    shown = sitting.environment.tree.documents[doc]
    assert shown.is_dirty and str(shown.undo) == "making grav and robot the supermodule arm"
    sitting.do(act.Save(doc))
    assert "GROUP       arm grav robot\n" in sitting.base.configuration_file("move").read_text()
    sitting.do(act.Undo(doc))
    assert groups(sitting) == {} and sitting.environment.tree.documents[doc].is_dirty
    sitting.do(act.Redo(doc))
    assert groups(sitting) == {"arm": ("grav", "robot")} and not sitting.environment.tree.documents[doc].is_dirty


def test_a_supermodule_gets_another_order_name_or_extent_by_being_made_again(sitting):  # R-C17
    doc = sitting.new("robot", "grav", "pd")
    sitting.do(act.Group(doc, "arm", ("grav", "robot", "grav")))
    sitting.do(act.Group(doc, "arm", ("robot", "grav")))
    assert groups(sitting) == {"arm": ("robot", "grav")}
    sitting.do(act.Group(doc, "puma", ("grav", "robot", "pd")))
    assert groups(sitting) == {"puma": ("grav", "robot", "pd")}
    sitting.do(act.Group(doc, "puma", ("pd",)))
    assert groups(sitting) == {"puma": ("pd",)}


def test_a_part_of_another_supermodule_is_not_taken_without_a_word(sitting):  # R-C17, R-X01
    doc = sitting.new("robot", "grav", "pd")
    sitting.do(act.Group(doc, "arm", ("grav", "robot")))
    no = sitting.no(act.Group(doc, "control", ("pd", "grav")))
    assert str(no.reason) == "control is not made: grav is in the supermodule arm already"
    assert remedies(no) == {
        "Take all of arm": act.Group(doc, "control", ("pd", "grav", "robot")),
        "Expand arm": act.Ungroup(doc, "arm"),
    }
    sitting.do(no.remedies[0].act)
    assert groups(sitting) == {"control": ("pd", "grav", "robot")}


@pytest.mark.parametrize(
    ("wish", "reason"),
    [
        (act.Group("c1", "arm", ("pd",)), "arm is not made: there is a supermodule arm already"),
        (act.Group("c1", "../x", ("pd",)), "'../x' is no name for a supermodule"),
        (act.Group("c1", "x", ()), "nothing is selected"),
        (act.Group("c1", "x", ("pd", "gone")), "there is no gone on the canvas"),
        (act.Ungroup("c1", "x"), "there is no supermodule x"),
        (act.SaveGroup("c1", "x"), "there is no supermodule x"),
        (act.TurnGroup("c1", "x", True), "there is no supermodule x"),
        (act.TurnGroup("c1", "arm", True), "Untitled-1 is not connected: its tasks do not live"),
        (act.Insert("c1", "nothing", 0, 0), "no base directory on the search path has a configuration nothing"),
        (act.Group("c9", "x", ("pd",)), "this configuration is no longer open"),
        (act.Ungroup("c9", "arm"), "this configuration is no longer open"),
        (act.SaveGroup("c9", "arm"), "this configuration is no longer open"),
        (act.Insert("c9", "move", 0, 0), "this configuration is no longer open"),
        (act.TurnGroup("c9", "arm", True), "this configuration is no longer open"),
    ],
)
def test_what_cannot_be_done_with_a_supermodule_is_said(sitting, wish, reason):  # R-C17, R-X01
    sitting.new("robot", "pd")
    sitting.do(act.Group("c1", "arm", ("robot",)))
    assert str(sitting.no(wish).reason) == reason


def test_a_task_that_goes_leaves_its_supermodule_and_the_last_one_takes_it_along(sitting):  # R-C17
    doc = sitting.new("robot", "grav", "pd")
    sitting.do(act.Group(doc, "arm", ("grav", "robot")))
    sitting.do(act.Remove(doc, ("grav",)))
    assert groups(sitting) == {"arm": ("robot",)}
    sitting.do(act.Remove(doc, ("robot",)))
    assert groups(sitting) == {}
    sitting.do(act.Undo(doc))
    sitting.do(act.Undo(doc))
    assert groups(sitting) == {"arm": ("grav", "robot")}


# -- saving and recalling


def test_a_saved_supermodule_is_recalled_whole_with_its_places_and_its_order(sitting):  # R-C17
    doc = sitting.new("robot", "grav", "pd")
    sitting.do(act.Save(doc, "move", str(sitting.base.path)))
    sitting.do(act.Move(doc, {}, {"KP": (70, 40)}))
    sitting.do(act.Group(doc, "arm", ("pd", "robot")))
    path = sitting.do(act.SaveGroup(doc, "arm"))
    saved, faults = conf.read(sitting.base.configuration_file("arm").read_text(), "arm", path)
    assert faults == () and saved.groups == (Group("arm", ("pd", "robot")),)
    assert {locus.svar: locus.conns for locus in saved.loci} == {"KP": 2, "Q_MEZ": 2, "TAU": 2, "Q_REF": 1}
    other = sitting.new("grav")
    assert sitting.do(act.Insert(other, "arm", 1000, 500)) == ("robot", "pd")
    assert groups(sitting, other) == {"arm": ("pd", "robot")}
    assert spots(sitting, other) == {"grav": (0, 100), "robot": (1000, 500), "pd": (1400, 500)}
    shown = sitting.environment.tree.documents[other]
    assert (shown.loci["KP"].x, shown.loci["KP"].y) == (1070, 440) and str(shown.undo) == "inserting arm"
    sitting.do(act.Undo(other))
    assert spots(sitting, other) == {"grav": (0, 100)} and groups(sitting, other) == {}


def test_where_a_supermodule_could_be_saved_is_said(sitting):  # R-X01
    doc = sitting.new("robot")
    sitting.do(act.Group(doc, "arm", ("robot",)))
    no = sitting.no(act.SaveGroup(doc, "arm"))
    assert str(no.reason) == "Untitled-1 has no file yet: say in which base directory arm is to be"
    assert sitting.do(no.remedies[0].act) == str(sitting.base.configuration_file("arm"))


def test_a_file_that_is_there_is_overwritten_only_when_that_is_meant(sitting):  # R-C17, R-X01
    doc = sitting.new("robot", "pd")
    sitting.do(act.Save(doc, "move", str(sitting.base.path)))
    sitting.do(act.Group(doc, "arm", ("robot", "pd")))
    sitting.do(act.SaveGroup(doc, "arm"))
    sitting.do(act.Group(doc, "arm", ("robot",)))
    before = sitting.base.configuration_file("arm").read_text()
    no = sitting.no(act.SaveGroup(doc, "arm"))
    assert sitting.base.configuration_file("arm").read_text() == before
    sitting.do(remedies(no)["Overwrite it"])
    assert "GROUP       arm robot\n" in sitting.base.configuration_file("arm").read_text()


def test_a_supermodule_never_overwrites_the_configuration_that_it_is_a_part_of(sitting):  # R-C17
    doc = sitting.new("robot", "pd")
    sitting.do(act.Save(doc, "arm", str(sitting.base.path)))
    sitting.do(act.Group(doc, "arm", ("robot",)))
    no = sitting.no(act.SaveGroup(doc, "arm", overwrites=True))
    assert "is the file of the configuration that arm is a part of" in str(no.reason)


def test_a_configuration_without_supermodules_is_inserted_as_one_in_the_order_of_its_file(sitting, tmp_path):  # R-C17
    Laboratory(tmp_path).configuration("control", "pd 50", "grav 100 rt1")
    doc = sitting.new("robot")
    sitting.do(act.Insert(doc, str(sitting.base.configuration_file("control")), 0, 300))
    assert groups(sitting) == {"control": ("pd", "grav")}
    shown = sitting.environment.tree.documents[doc].tasks
    assert (shown["pd"].hz, shown["grav"].rtpu) == (50.0, "rt1")


def test_the_supermodules_of_an_inserted_file_become_parts_of_the_new_one(sitting):  # R-C17
    doc = sitting.new("robot", "grav", "pd")
    sitting.do(act.Group(doc, "arm", ("pd", "robot")))
    sitting.do(act.Save(doc, "move", str(sitting.base.path)))
    other = sitting.new("cubic")
    sitting.do(act.Insert(other, "move", 0, 300))
    assert groups(sitting, other) == {"move": ("pd", "robot", "grav")}


def test_nothing_is_inserted_where_one_task_may_not_be_and_every_reason_is_named(sitting):  # R-C07, R-C17, R-X01
    doc = sitting.new("trapez", "pd", "grav")
    sitting.do(act.Save(doc, "arm", str(sitting.base.path)))
    other = sitting.new("cubic", "pd")
    sitting.do(act.Group(other, "arm", ("pd",)))
    no = sitting.no(act.Insert(other, "arm", 0, 0))
    for reason in (
        "arm is not inserted: there is a supermodule arm already",
        "trapez: writes Q_REF, which `cubic` already writes",
        "`pd` is placed already",
    ):
        assert reason in str(no.reason)
    assert "grav" not in str(no.reason)
    assert remedies(no)["Show pd"] == ShowTask("pd") and remedies(no)["Expand arm"] == act.Ungroup(other, "arm")


def test_an_empty_configuration_is_no_supermodule(sitting, tmp_path):  # R-C17
    Laboratory(tmp_path).configuration("blank")
    assert str(sitting.no(act.Insert(sitting.new(), "blank", 0, 0)).reason) == "blank has no tasks"


# -- in the running system


def test_a_supermodule_comes_on_in_its_order_and_goes_off_the_other_way_round(duet):  # R-C17
    doc = duet.connected("robot", "grav", "cubic")
    duet.do(act.Group(doc, "arm", ("cubic", "grav", "robot")))
    duet.do(act.TurnGroup(doc, "arm", is_on=True))
    assert [turn.task for turn in duet.edits()[-1].on] == ["cubic", "grav", "robot"]
    assert str(duet.document(doc).history.last.label) == "turning arm ON"
    duet.do(act.TurnGroup(doc, "arm", is_on=False))
    assert duet.edits()[-1].off == ("robot", "grav", "cubic")
    assert {duet.state(doc, name) for name in ("cubic", "grav", "robot")} == {"OFF"}


def test_an_inserted_supermodule_is_spawned_as_one_change_in_its_order(duet):  # R-C17, R-X10
    doc = duet.new("robot", "cubic", "grav")
    duet.do(act.Group(doc, "arm", ("grav", "cubic", "robot")))
    duet.do(act.SaveGroup(doc, "arm", str(duet.base.path)))
    other = duet.connected()
    count = len(duet.edits())
    duet.do(act.Insert(other, "arm", 0, 0))
    (change,) = duet.edits()[count:]
    assert [task.name for task in change.spawn] == ["grav", "cubic", "robot"]
    duet.do(act.Undo(other))
    assert duet.edits()[-1].kill and duet.runtime.lives[duet.document(other).live.subsystem] == {}


def test_who_supplies_a_constant_is_spawned_first_whatever_the_supermodule_says(duet):  # R-C17, law 10
    doc = duet.new("robot", "pd", "grav")
    duet.do(act.Group(doc, "arm", ("grav", "pd", "robot")))
    duet.do(act.Connect(doc))
    names = [task.name for task in duet.edits()[-1].spawn]
    assert names == ["grav", "pd", "robot"]
    tasks = {task.name: task for task in TASKS}
    carried_out = exchange([], (), [Standing(Ports.of(tasks[name]), name) for name in names])
    assert carried_out.spawn == ("grav", "robot", "pd")  # as every runtime does


def test_an_inserted_supermodule_that_cannot_live_is_not_inserted(duet):  # R-C17, R-X10
    doc = duet.new("robot", "grav")
    duet.do(act.Group(doc, "arm", ("grav", "robot")))
    duet.do(act.SaveGroup(doc, "arm", str(duet.base.path)))
    (duet.base.path / "module" / "grav.py").unlink()
    other = duet.connected()
    assert "grav cannot live" in str(duet.no(act.Insert(other, "arm", 0, 0)).reason)
    assert spots(duet, other) == {} and groups(duet, other) == {}


def test_a_supermodule_is_whole_again_where_a_removal_came_to_nothing(duet):  # R-C17, R-X10
    doc = duet.connected("robot", "grav")
    duet.do(act.Group(doc, "arm", ("grav", "robot")))
    duet.runtime.refusals = {"Change": "no room"}
    duet.answer(act.Remove(doc, ("grav",)))
    assert groups(duet) == {"arm": ("grav", "robot")}
    assert set(spots(duet)) == {"robot", "grav"}
