from dataclasses import replace

from kit.desk.app_fixture import AppFixture
from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.state.open_application import Judgement
from onika.model.task import Task
from onika.wire import act
from onika.wire.view import FaultView
from onika.words.reason import Reason

TASKS = (
    Task("memory", "m", invar=("M",), outvar=("M",), frequency=1.0),
    Task("reader", "m", invar=("Q",), frequency=1.0),
)


def test_a_check_gives_every_sentence_what_is_wrong_first_and_also_where_warnings_are_off(tmp_path):  # R-C26
    sitting = EnvironmentFixture(tmp_path, TASKS)
    (tmp_path / "conf").mkdir()
    sitting.base.configuration_file("c").write_text("RMODFILE memory\nCOORDS 0 0\nRMODFILE reader\nCOORDS 0 0\nEOF\n")
    doc = sitting.do(act.Open(str(sitting.base.configuration_file("c"))))
    sitting.do(act.Prefer({"shows_warnings": False}))
    fault, warning, note = sitting.do(act.Check(doc))
    assert "its module `m` is used already, by `memory`" in str(fault)
    assert "a task that writes Q, found only `reader`" in str(warning)
    assert "M, which it does both" in str(note)
    assert len(sitting.environment.tree.documents[doc].problems) == 1


def test_nothing_is_said_where_all_is_well(tmp_path):  # R-C26
    sitting = EnvironmentFixture(tmp_path)
    assert sitting.do(act.Check(sitting.new())) == ()
    assert "no longer open" in str(sitting.no(act.Check("c9")).reason)


def test_what_is_wrong_with_an_application_is_told_as_it_was_judged_last(tmp_path):  # R-E01
    gallery = AppFixture(tmp_path)
    doc = gallery.begun("grip")
    assert gallery.do(act.Check(doc)) == ()
    opened = gallery.environment.model.applications[doc]
    faults = (FaultView(Reason.plain("is odd"), "warning"), FaultView(Reason.plain("is wrong")))
    judged = replace(opened, judgement=Judgement(opened.application, faults))
    gallery.environment.model = gallery.environment.model.with_application(judged)
    assert tuple(map(str, gallery.do(act.Check(doc)))) == ("is wrong", "is odd")
