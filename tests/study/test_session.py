"""The task of a session: from New to the run that succeeded."""

from kit.study.log_text import LogText
from onika.study import log as logs
from onika.study.session import attempts_of, task_of


def task(text, succeeded=None):
    log, faults = logs.read(text, "p1.log")
    assert faults == ()
    return task_of(log, succeeded)


def keys(faults):
    return [fault.reason.key for fault in faults]


def test_the_task_ends_with_the_first_run_that_completed():  # R-H02
    log = LogText().start().new().select(4).insert(2).run(9, 20, "a box fell").select(3).insert(1).run(5, 30).quit()
    of, faults = task(log.text)
    assert faults == ()
    assert [attempt.is_completed for attempt in of.attempts] == [False, True]
    assert of.success == of.attempts[1]
    assert of.entries[0].event == "new_appl"
    assert of.entries[-1].event == "end_appl"


def test_a_demonstration_before_is_not_the_task():  # R-H02
    log = LogText().start().new().insert(2).run(9, 20).delete(3, 1).new(60).select(4).insert(2).run(5, 30).quit()
    of, faults = task(log.text)
    assert keys(faults) == ["study.parts_before"]
    assert faults[0].place.line == 8
    assert len(of.attempts) == 1
    assert of.entries[0].line == 8


def test_who_begins_anew_within_the_task_has_all_of_the_time():  # R-H02
    log = LogText().start().new().select(4).insert(2).new(8).select(4).insert(2).run(5, 30).quit()
    of, faults = task(log.text)
    assert faults == ()
    assert of.entries[0].line == 3


def test_the_experimenter_says_which_attempt_succeeded():  # R-H02
    text = LogText().start().new().select(4).insert(2).run(9, 20).select(3).insert(1).run(5, 30).quit().text
    unsaid, faults = task(text)
    assert keys(faults) == ["study.several_completed"]
    assert (len(unsaid.attempts), unsaid.later) == (1, 1)
    second, faults = task(text, 2)
    assert faults == ()
    assert (len(second.attempts), second.later) == (2, 0)
    none, faults = task(text, 0)
    assert none.success is None
    assert faults == ()
    wrong, faults = task(text, 3)
    assert wrong.success is None
    assert keys(faults) == ["study.no_such_attempt"]


def test_an_attempt_that_is_refused_is_one_in_our_log_and_a_press_in_that_of_the_thesis():  # R-H02
    ours = LogText().put(3.25, "try_run_appl").put(2.5, "run_appl").text
    thesis = "5 try_run_appl none 0 none 0 none\n5 run_appl U 3 none 0 none\n"
    refused = "5 try_run_appl none 0 none 0 none\n9 run_appl U 3 none 0 none\n"
    for text, expected in ((ours, [False, True]), (thesis, [True]), (refused, [False, True])):
        log, _ = logs.read(text, "x")
        assert [attempt.is_run for attempt in attempts_of(log.entries)] == expected


def test_a_run_without_end_and_an_end_without_run_are_told():  # R-H02
    log = LogText().start().new().insert(2).put(1, "run_appl").insert(3).run(5, 30)
    log.put(2, "end_appl", "U", "a1", "completed", "7", "appl").quit()
    of, faults = task(log.text)
    assert keys(faults) == ["study.run_without_end", "study.end_without_run"]
    assert [attempt.end_s is None for attempt in of.attempts] == [True, False]


def test_a_log_without_a_new_application_counts_from_its_beginning():  # R-H02
    of, faults = task(LogText().start().select(4).insert(2).run(5, 30).quit().text)
    assert keys(faults) == ["study.no_new"]
    assert of.entries[0].event == "Start_Onika"


def test_an_empty_log_has_an_empty_task():  # R-H02
    of, faults = task("")
    assert (of.entries, of.attempts, of.success, faults) == ((), (), None, ())
