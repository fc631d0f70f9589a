from dataclasses import replace

import pytest

from kit.desk.dictionary_fixture import DictionaryFixture, plain
from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.outcome.outcome import Done
from onika.files import syntax as syntax_file
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.task import Task
from onika.store.shipped import shipped
from onika.wire import act
from onika.wire.view import ShowSaveAs

TASKS = (
    Task("jmove", "jmove", invar=("Q",), outvar=("Q_REF",), frequency=1.0, object_type="Joint job"),
    Task("pd", "pd", outvar=("Q",), frequency=1.0),
)
SYNTAX = syntax_file.read((shipped() / "prefs" / syntax_file.NAME).read_text(), "s", "s")[0]
BLANK = "".join(blank().rows)
DRAWN = "7" * 512 + "9" + "0" * 511


@pytest.fixture
def sitting(tmp_path):
    return EnvironmentFixture(tmp_path, TASKS)


@pytest.fixture
def doc(sitting):
    doc = sitting.new("jmove")
    sitting.do(act.Save(doc, "move", str(sitting.base.path)))
    return doc


def onikon(sitting, name="move"):
    return sitting.base.onikon(name, SYNTAX)[0]


def test_a_configuration_is_saved_first(sitting):  # R-C16
    doc = sitting.new("jmove")
    for request in (act.Draft(doc), act.MakeJob(doc, BLANK)):
        assert [remedy.show for remedy in sitting.no(request).remedies] == [ShowSaveAs()]
    sitting.do(act.Save(doc, "move", str(sitting.base.path)))
    sitting.do(act.Place(doc, "pd", 0, 300))
    no = sitting.no(act.MakeJob(doc, BLANK))
    assert no.remedies[0].act == act.Save(doc)
    sitting.do(no.remedies[0].act)
    sitting.do(act.Move(doc, {"pd": (9, 9)}))  # its looks are no part of a job
    assert sitting.do(act.Draft(doc)).type == "Joint job"


def test_a_draft_says_what_the_job_would_be(sitting, doc):  # R-C16
    draft = sitting.do(act.Draft(doc))
    assert (draft.name, draft.type, draft.picture, draft.description) == ("move", "Joint job", "", "")
    kind = SYNTAX.find("Joint job")
    assert (draft.left_edge, draft.right_edge) == (str(kind.left_edge), str(kind.right_edge))
    assert draft.path == str(sitting.base.onikon_file("move"))
    assert "writes Q" in str(draft.warnings[0])


def test_hanging_inputs_are_told_unless_warnings_are_off(sitting, doc):  # R-C08
    sitting.do(act.Prefer({"shows_warnings": False}))
    assert sitting.do(act.Draft(doc)).warnings == ()


def test_a_job_is_made_and_offered_again(sitting, doc):  # R-C16, R-D07
    path = sitting.do(act.MakeJob(doc, DRAWN, "moves\n the  joints"))
    made = onikon(sitting)
    assert path == str(sitting.base.onikon_file("move"))
    assert (made.type, made.description) == ("Joint job", "moves the joints")
    assert made.picture.rows[0] == "8" * 32
    assert made.picture.rows[16][:2] == "80"
    draft = sitting.do(act.Draft(doc))
    assert (draft.picture, draft.description) == ("".join(made.picture.rows), "moves the joints")
    assert [say.level for say in sitting.says] == ["success"]


def test_a_9_is_read_as_black(sitting, doc):  # reading 38
    sitting.do(act.MakeJob(doc, "7" * 513 + "9" + "7" * 510))
    assert onikon(sitting).picture.rows[16][1] == "8"


@pytest.mark.parametrize("picture", ["", "7" * 1023, "7" * 1025, "7" * 1023 + "x", "७" * 1024, "7" * 1023 + "²"])
def test_a_picture_that_is_none_is_refused(sitting, doc, picture):  # R-D07
    assert list(sitting.no(act.MakeJob(doc, picture)).fields) == ["picture"]
    assert onikon(sitting) is None


def test_an_icon_that_is_there_is_replaced_only_where_that_is_meant(sitting, doc):  # R-C16
    sitting.do(act.MakeJob(doc, BLANK, "first"))
    path = sitting.base.onikon_file("move")
    path.write_text("# by hand\n" + path.read_text())
    no = sitting.no(act.MakeJob(doc, BLANK, "second"))
    assert "is there already" in str(no.reason)
    sitting.do(no.remedies[0].act)
    assert onikon(sitting).description == "second"
    assert "# by hand" in path.read_text()


def test_the_icon_of_an_application_is_replaced_only_where_that_is_meant(sitting, doc):  # reading 34
    sitting.base.save_onikon(Onikon("move", "Complete application", "theirs", (), blank()))
    no = sitting.no(act.MakeJob(doc, BLANK))
    assert "the icon of something else" in str(no.reason)
    assert no.reason in sitting.do(act.Draft(doc)).warnings
    sitting.do(no.remedies[0].act)
    assert onikon(sitting).type == "Joint job"


def test_where_it_cannot_be_written_the_reason_is_given(sitting, doc):
    sitting.base.onikon_file("x").parent.write_text("no folder")
    assert "cannot be saved" in str(sitting.no(act.MakeJob(doc, BLANK)).reason)


def test_what_was_changed_of_a_task_and_not_saved_is_told(sitting, doc):  # R-C04
    edits = {"jmove": replace(TASKS[0], aliases=(("Q", "Q_2"),))}
    sitting.environment.become(lambda now: Done(replace(now, libraries=now.libraries.edited(edits))))
    assert "jmove was changed here" in str(sitting.do(act.Draft(doc)).warnings[0])


def test_no_job_is_made_of_nothing(sitting):  # R-C16
    doc = sitting.new()
    sitting.do(act.Save(doc, "empty", str(sitting.base.path)))
    assert str(sitting.no(act.Draft(doc)).reason) == "`empty` has no tasks"
    assert "no longer open" in str(sitting.no(act.Draft("c9")).reason)


def test_the_dictionary_has_the_job_at_once(tmp_path):  # R-C16, R-D01
    cabinet = DictionaryFixture(tmp_path)
    doc = cabinet.do(act.Open("pauseC"))
    cabinet.do(act.Save(doc, "napC", str(cabinet.own.path)))
    cabinet.do(act.MakeJob(doc, BLANK, "wait"))
    view = cabinet.icon("napC")
    assert (view.type, view.description, str(view.trouble)) == ("Pause job", "wait", "")
    assert view.source == str(cabinet.own.configuration_file("napC"))
    cabinet.look()
    assert cabinet.icon("napC") == view


def test_an_icon_keeps_what_it_says_in_other_languages_as_long_as_it_says_the_same(tmp_path):  # R-X11
    cabinet = DictionaryFixture(tmp_path)
    doc = cabinet.do(act.Open("pauseC"))
    cabinet.do(act.Save(doc, "napC", str(cabinet.own.path)))
    cabinet.own.save_onikon(replace(plain("napC", "Pause job", "wait"), words=(("es", "espera"),)))
    cabinet.look()
    cabinet.do(act.MakeJob(doc, BLANK, "wait", overwrites=True))
    assert cabinet.icon("napC").words == {"es": "espera"}
    cabinet.do(act.MakeJob(doc, BLANK, "rest", overwrites=True))
    assert cabinet.icon("napC").words == {} and "in other languages (es) is gone" in str(cabinet.says[-1].text)
