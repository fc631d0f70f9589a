from hypothesis import given, strategies as st

from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.file.undo import edits_between, moved_wanted
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.configuration import Configuration
from onika.model.task import Task
from onika.wire import act

wants = st.dictionaries(st.sampled_from("abc"), st.booleans())


def content(wanted):
    return Content(Configuration("c"), wanted)


@given(wants, wants)
def test_what_a_step_changed_is_what_taking_it_back_changes(start, end):  # law 22
    assert moved_wanted(end, content(end), content(start)) == start


@given(wants, wants)
def test_what_has_changed_since_and_was_not_of_the_step_stays(now, same):  # law 22
    assert moved_wanted(now, content(same), content(same)) == now


def test_edits_are_told_by_name_and_none_is_as_the_file_says():
    task = Task("t", "m")
    assert edits_between(OpenLibraries(), OpenLibraries()) == {}
    assert edits_between(OpenLibraries(), OpenLibraries(edits={"t": task})) == {"t": task}
    assert edits_between(OpenLibraries(edits={"t": task}), OpenLibraries()) == {"t": None}


def test_there_is_nothing_to_take_back_at_first(tmp_path):  # R-X10
    sitting = EnvironmentFixture(tmp_path, (Task("t", "m", outvar=("Q",), frequency=1.0),))
    doc = sitting.new()
    assert "nothing" in str(sitting.no(act.Undo(doc)).reason)
    assert "nothing" in str(sitting.no(act.Redo(doc)).reason)
    assert "no longer open" in str(sitting.no(act.Undo("c9")).reason)


def test_a_task_that_was_saved_with_its_rate_is_what_it_was(tmp_path):  # law 22: nothing that lives is exchanged for it
    sitting = EnvironmentFixture(tmp_path, (Task("t", "m", outvar=("Q",), frequency=1.0),))
    sitting.do(act.Alias("t", "Q", "R"))
    sitting.do(act.LibraryRate("t", 5.0))
    before = sitting.environment.model.libraries
    sitting.do(act.SaveTask("t"))
    after = sitting.environment.model.libraries
    assert after.edits != before.edits
    assert edits_between(before, after) == {}
