from dataclasses import replace

import pytest
from hypothesis import given, settings, strategies as st

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.installed_fixture import InstalledFixture
from kit.examples import examples
from onika.files import rmod
from onika.model.task import Task, TaskType
from onika.wire import act
from onika.wire.view import ShowPin, ShowTask

WRITER = Task("writer", "w", invar=("IN",), outvar=("Q", "R"), frequency=10.0)
OTHER = Task("other", "o", outvar=("P",), frequency=10.0)
READER = Task("reader", "r", invar=("Q",), frequency=10.0)
SLOW = Task("slow", "s", type=TaskType.APERIODIC)


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, (WRITER, OTHER, READER, SLOW))


def svars(sitting, doc):
    return [locus.svar for locus in sitting.environment.model.documents[doc].content.configuration.loci]


def spot(sitting, doc, svar):
    loci = sitting.environment.model.documents[doc].content.configuration.loci
    return next((locus.x, locus.y) for locus in loci if locus.svar == svar)


def task(sitting, name):
    return sitting.environment.model.libraries.tasks[name]


def file(sitting, name):
    return sitting.base.task_file(name)


def test_an_alias_of_the_library_reaches_every_open_configuration(sitting):  # R-C04, reading 9
    first, two, away = sitting.new("writer", "reader"), sitting.new("writer"), sitting.new()
    sitting.do(act.Alias("writer", "Q", "GOAL", away))
    assert task(sitting, "writer").aliases == (("Q", "GOAL"),)
    assert svars(sitting, first) == ["IN", "Q", "R", "GOAL"]
    assert svars(sitting, two) == ["IN", "GOAL", "R"]
    assert sitting.environment.tree.tasks["writer"].is_changed


def test_a_locus_that_only_this_pin_used_keeps_its_place_under_the_new_name(sitting):  # R-C24
    doc = sitting.new("writer")
    sitting.do(act.Move(doc, loci={"R": (700, 700)}))
    sitting.do(act.Alias("writer", "R", "S", doc))
    assert spot(sitting, doc, "S") == (700, 700)


def test_undo_takes_an_alias_back_everywhere_and_redo_brings_it_again(sitting):  # R-X10, R-C04
    first, two, away = sitting.new("writer", "reader"), sitting.new("writer"), sitting.new()
    before = [sitting.environment.model.documents[doc].content for doc in (first, two)]
    sitting.do(act.Alias("writer", "Q", "GOAL", away))
    after = [sitting.environment.model.documents[doc].content for doc in (first, two)]
    assert str(sitting.environment.tree.documents[away].undo) == "aliasing Q of writer to GOAL"
    sitting.do(act.Undo(away))
    assert [sitting.environment.model.documents[doc].content for doc in (first, two)] == before
    assert task(sitting, "writer") == WRITER
    sitting.do(act.Redo(away))
    assert [sitting.environment.model.documents[doc].content for doc in (first, two)] == after


def test_what_was_done_before_an_alias_of_another_document_is_taken_back_with_its_variables(sitting):  # R-X10
    first, two = sitting.new("writer"), sitting.new()
    sitting.do(act.Remove(first, ("writer",)))
    sitting.do(act.Alias("writer", "Q", "GOAL", two))
    sitting.do(act.Undo(first))
    assert sorted(svars(sitting, first)) == ["GOAL", "IN", "R"]


def test_an_alias_that_would_clash_in_another_open_configuration_is_refused_with_its_ways_out(sitting):  # reading 9
    here, there = sitting.new(), sitting.new("writer", "other")
    no = sitting.no(act.Alias("writer", "Q", "P", here))
    name = sitting.environment.model.documents[there].name
    assert str(no.reason) == f"Q of writer cannot be P: in {name}, writer writes P, which `other` already writes"
    assert {field: str(why) for field, why in no.fields.items()} == {
        "svar": f"in {name}, writer writes P, which `other` already writes"
    }
    assert no.remedies[0].act == act.Remove(there, ("other",))
    assert [remedy.show for remedy in no.remedies[1:]] == [ShowPin("other", "P"), ShowTask("other")]
    sitting.do(no.remedies[0].act)
    sitting.do(act.Alias("writer", "Q", "P", here))


def test_undo_is_refused_where_it_would_clash_by_now(sitting):  # reading 9, R-X10
    doc, other = sitting.new(), sitting.new()
    sitting.do(act.Alias("writer", "Q", "FREE", doc))
    sitting.new("writer", "other")
    sitting.do(act.Alias("other", "P", "Q", other))
    assert "cannot be taken back" in str(sitting.no(act.Undo(doc)).reason)
    sitting.do(act.Undo(other))
    sitting.do(act.Undo(doc))
    assert task(sitting, "writer") == WRITER


def test_two_outputs_of_one_variable_are_refused_though_nothing_is_placed(sitting):  # reading 9
    no = sitting.no(act.Alias("writer", "Q", "R"))
    assert "would both write R" in str(no.reason)
    assert no.remedies[0].show == ShowPin("writer", "R")


@pytest.mark.parametrize("svar", ["q", "1Q", "Q R", "Q=R", "É", "Q\n#"])
def test_what_is_no_name_of_a_variable_is_refused_beside_its_field(sitting, svar):  # R-C04
    no = sitting.no(act.Alias("writer", "Q", svar))
    assert "expected capital letters" in str(no.fields["svar"])


def test_a_task_or_pin_that_is_not_there_is_named(sitting):  # R-C04
    assert str(sitting.no(act.Alias("nobody", "Q", "R")).reason) == "no open library has a task nobody"
    assert str(sitting.no(act.Alias("writer", "Z", "R")).reason) == "writer has no pin Z"
    assert "nobody" in str(sitting.no(act.LibraryRate("nobody", 1.0)).reason)
    assert "nobody" in str(sitting.no(act.SaveTask("nobody")).reason)
    assert "nobody" in str(sitting.no(act.ForgetTask("nobody")).reason)


names = st.sampled_from(["", "A", "B", "C", "D", "Z"])


@given(st.lists(st.tuples(st.sampled_from("ABC"), names), max_size=8))
@settings(max_examples=examples(40), deadline=None)
def test_aliases_are_resolved_once_whatever_was_aliased_before(tmp_path_factory, changes):  # R-C04
    swap = Task("swap", "swap", invar=("A", "B", "C"), frequency=1.0)
    sitting = EnvironmentFixture(tmp_path_factory.mktemp("swap"), (swap,))
    doc = sitting.new("swap")
    wished = {}
    for pin, svar in changes:
        sitting.do(act.Alias("swap", pin, svar, doc))
        wished[pin] = svar or pin
    view = sitting.environment.tree.documents[doc].own.get("swap") or sitting.environment.tree.tasks["swap"]
    assert {pin.name: pin.svar for pin in view.pins} == {"A": "A", "B": "B", "C": "C"} | wished
    assert set(svars(sitting, doc)) == {pin.svar for pin in view.pins}
    sitting.do(act.SaveTask("swap"))
    assert rmod.read(file(sitting, "swap").read_text(), "swap", "")[0].task == task(sitting, "swap")
    assert not sitting.environment.tree.tasks["swap"].is_changed
    for _ in sitting.environment.model.documents[doc].history.past[1:]:
        sitting.do(act.Undo(doc))
    assert task(sitting, "swap") == swap


def test_a_rate_of_the_library_holds_for_later_placements_and_no_step_is_made(sitting):  # reading 10
    doc = sitting.new("reader")
    sitting.do(act.LibraryRate("writer", 25.0))
    sitting.do(act.Place(doc, "writer", 0, 0))
    configuration = sitting.environment.model.documents[doc].content.configuration
    assert [placed.frequency for placed in configuration.placed] == [0.0, 25.0]
    assert (sitting.environment.tree.tasks["writer"].hz, sitting.environment.tree.tasks["writer"].file_hz) == (
        25.0,
        10.0,
    )
    sitting.do(act.LibraryRate("writer", 10.0))
    assert sitting.environment.model.libraries.rates == {}


@pytest.mark.parametrize("hz", [0.0, -1.0, float("nan"), float("inf")])
def test_a_rate_that_is_none_is_refused(sitting, hz):  # R-C04
    assert "above 0" in str(sitting.no(act.LibraryRate("writer", hz)).fields["hz"])


def test_only_periodic_tasks_have_a_rate_to_set(sitting):  # R-C04
    assert "aperiodic" in str(sitting.no(act.LibraryRate("slow", 5.0)).fields["hz"])


def test_saving_a_task_writes_what_was_changed_and_nothing_else(sitting):  # R-C04
    file(sitting, "writer").write_text(file(sitting, "writer").read_text().replace("DESC", "# kept\nDESC"))
    sitting = EnvironmentFixture(sitting.base.path)
    sitting.do(act.Alias("writer", "Q", "GOAL"))
    sitting.do(act.LibraryRate("writer", 20.0))
    assert sitting.do(act.SaveTask("writer")) == str(file(sitting, "writer"))
    text = file(sitting, "writer").read_text()
    assert "# kept" in text
    assert rmod.read(text, "writer", "")[0].task == replace(WRITER, aliases=(("Q", "GOAL"),), frequency=20.0)
    libraries = sitting.environment.model.libraries
    assert (libraries.edits, libraries.rates) == ({}, {})
    assert str(libraries.records["writer"].text) == text
    assert not sitting.environment.tree.tasks["writer"].is_changed


def test_a_task_that_is_as_its_file_says_is_not_written(sitting):  # R-C04
    before = file(sitting, "writer").stat().st_mtime_ns
    sitting.do(act.SaveTask("writer"))
    assert file(sitting, "writer").stat().st_mtime_ns == before


def test_a_file_that_somebody_else_changed_is_overwritten_only_when_meant(sitting):  # R-B07
    sitting.do(act.Alias("writer", "Q", "GOAL"))
    theirs = file(sitting, "writer").read_text().replace("FREQ        10", "FREQ        40")
    file(sitting, "writer").write_text(theirs)
    no = sitting.no(act.SaveTask("writer"))
    assert "has changed since it was read" in str(no.reason)
    assert file(sitting, "writer").read_text() == theirs
    sitting.do(no.remedies[0].act)
    assert "GOAL" in file(sitting, "writer").read_text()


def test_forgetting_takes_the_task_as_its_file_says_now(sitting):  # R-C04
    doc = sitting.new("writer")
    sitting.do(act.Alias("writer", "Q", "GOAL"))
    sitting.do(act.LibraryRate("writer", 20.0))
    file(sitting, "writer").write_text(file(sitting, "writer").read_text().replace("FREQ        10", "FREQ        40"))
    sitting.do(act.ForgetTask("writer"))
    assert task(sitting, "writer") == replace(WRITER, frequency=40.0)
    assert sorted(svars(sitting, doc)) == ["IN", "Q", "R"]


def test_forgetting_is_refused_where_the_file_clashes_by_now(sitting):  # reading 9
    sitting.do(act.Alias("other", "P", "Q"))
    sitting.do(act.Alias("writer", "Q", "GOAL"))
    doc = sitting.new("writer", "other")
    assert "cannot be as its file says" in str(sitting.no(act.ForgetTask("writer")).reason)
    sitting.do(act.Remove(doc, ("other",)))
    sitting.do(act.ForgetTask("writer"))


def test_a_changed_task_of_a_shipped_library_is_saved_as_ones_own(tmp_path, monkeypatch):  # R-B07, R-C04
    installed = InstalledFixture(tmp_path, monkeypatch)
    installed.do(act.LibraryRate("pd", 123.0))
    path = installed.do(act.SaveTask("pd"))
    view = installed.environment.tree.tasks["pd"]
    assert path == str(installed.own.task_file("pd")) == view.path
    assert (view.hz, view.file_hz, view.is_changed) == (123.0, 123.0, False)
    assert installed.installed_files() == installed.before
    installed.do(act.LibraryRate("pd", 50.0))
    assert installed.do(act.SaveTask("pd")) == path
