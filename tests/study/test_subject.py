"""A subject by its logs or by a row of a table."""

import math

from kit.study.log_text import BEGIN_S, LogText, assembly
from onika.study import log as logs
from onika.study.subject import from_log, from_results
from onika.study.table import SubjectRow


def keys(faults):
    return [fault.reason.key for fault in faults]


def test_a_subject_has_the_figures_of_its_log():  # R-H02
    log, _ = logs.read(assembly(4.0), "p1.log")
    subject, faults = from_log("p1", [log], SubjectRow(2, "p1", {"group": "both"}))
    assert faults == ()
    assert (subject.group, subject.is_compared) == ("both", True)
    assert subject.figures == {"mean_selection_s": 4.0, "building_s": 82.0, "deletions": 0.0, "attempts": 1.0}


def test_several_logs_are_one_session_in_the_order_of_their_times():  # R-H02
    first = logs.read(LogText().start().new().select(4).insert(2).quit().text, "a.log")[0]
    second = logs.read(LogText(BEGIN_S + 500).start().select(6).insert(2).run(3, 9).quit().text, "b.log")[0]
    subject, faults = from_log("p1", [second, first], None)
    assert keys(faults) == ["study.second_session"]
    assert subject.figures["mean_selection_s"] == 5
    assert subject.figures["building_s"] == 18
    _, faults = from_log("p1", [first, logs.read(assembly(4.0, begin_s=BEGIN_S + 3), "c.log")[0]], None)
    assert "study.overlap" in keys(faults)


def test_a_log_without_anything_cannot_be_compared():  # R-H02
    subject, _ = from_log("p1", [logs.read("", "p1.log")[0]], None)
    assert not subject.is_compared
    assert subject.unfit.key == "study.empty_log"


def test_without_success_there_is_no_time_and_it_is_told():  # R-H02
    log, _ = logs.read(LogText().start().new().select(4).insert(2).quit().text, "p1.log")
    subject, faults = from_log("p1", [log], None)
    assert keys(faults) == ["study.no_success"]
    assert math.isnan(subject.figures["building_s"])
    assert subject.figures["mean_selection_s"] == 4


def test_a_row_of_results_gives_figures_and_names_what_is_none():  # R-H02
    row = SubjectRow(7, "p1", {"group": "both", "mean_selection_s": "6.1", "deletions": "few", "attempts": "-1"})
    subject, faults = from_results(row, SubjectRow(2, "p1", {"removed": "ill"}), "results.csv")
    assert subject.figures == {"mean_selection_s": 6.1}
    assert (subject.group, subject.removed, subject.is_compared) == ("both", "ill", False)
    assert keys(faults) == ["study.no_number", "study.no_number"]
    assert {fault.place.line for fault in faults} == {7}
