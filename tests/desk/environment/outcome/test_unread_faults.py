from dataclasses import replace

from kit.desk.app_fixture import ONIKONS, AppFixture
from onika.desk.environment.outcome.unread_faults import not_run, told
from onika.model.application import AppFlow, Application, Icon
from onika.wire import act
from onika.wire.view import ShowStep
from onika.words.fault import Fault, Place
from onika.words.reason import Reason


def test_a_fault_is_told_at_the_step_in_whose_lines_it_stands():
    first, second = (replace(Icon(ONIKONS[0]), line=line, number=number) for line, number in ((5, 1), (40, 2)))
    application = Application("a", False, (AppFlow((first, second)),))
    faults = (
        Fault(Place("a.appl", 3), Reason.plain("expected conditional, found odd"), Reason.plain("left out")),
        Fault(Place("a.appl", 39), Reason.plain("expected `x`, found y"), Reason.plain("left out")),
        Fault(
            Place("a.appl", 41),
            Reason.plain("expected a type, found Warp job"),
            Reason.plain("it acts as Complete job"),
            is_note=True,
        ),
    )
    head, first, two = told(application, faults, is_partial=True)
    assert (head.step, first.step, two.step) == (0, 1, 2)
    assert (str(head.text), head.level) == ("line 3 of its file: expected conditional, found odd", "fault")
    assert str(first.text).startswith("line 39 of its file: expected `x`")
    assert (two.level, str(two.text).endswith("it acts as Complete job")) == ("warning", True)
    assert {line.level for line in told(application, faults, is_partial=False)} == {"warning"}


def test_what_could_be_read_only_in_part_is_not_run(tmp_path):  # issue: bad input
    gallery = AppFixture(tmp_path)
    doc = gallery.begun("grip", "open")
    path = gallery.base.application_file("job1")
    gallery.do(act.Save(doc, "job1", str(gallery.base.path)))
    assert not_run(gallery.environment.model.applications[doc]) is None
    gallery.do(act.Close(doc))
    path.write_text(path.read_text().replace("MARKER      no", "MARKER      odd", 1))
    doc = gallery.do(act.Open(str(path)))
    no = gallery.no(act.Run(doc))
    assert str(no.reason).startswith("job1 could not be read whole: line ")
    assert no.remedies[0].show == ShowStep(gallery.number(doc, "grip"))
