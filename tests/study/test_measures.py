"""The statistics of §E.3, by hand, and that the parts of the time add up."""

import math
from dataclasses import fields
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

from kit.study.log_text import LogText
from onika.study import log as logs
from onika.study.measures import TaskMeasures, measure
from onika.study.session import task_of

THESIS = Path(__file__).parents[1] / "data" / "assemblies" / "thesis_pt3_abridged.raw"
WHOLE = """770909683 try_new_appl none 0 none 0 appl
770909685 new_appl Untitled-2 3577432 none 0 appl
770909690 select_icon opengripC 3496920 none 0 dict
770910051 insert_icon opengripC 3652992 Start 3684304 appl
770910110 try_run_appl none 0 none 0 none
770910110 run_appl Untitled-2 3577432 none 0 none
770910356 succeed_appl Untitled-2 3577432 none 0 none
"""


def measured(text, succeeded=None):
    log, _ = logs.read(text, "p1.log")
    return measure(task_of(log, succeeded)[0])


def test_the_subject_of_the_thesis_has_its_figures():  # R-H02
    """Those of §E.3 that its abridged log tells: the rest of the log, one icon, stands for what is not printed."""
    figures, _ = measured(WHOLE)
    assert figures.request_s == 2
    assert figures.elapsed_s == 673
    assert figures.building_s == 427  # table 2, pt3
    assert figures.check_s == 59
    assert figures.completed_run_s == figures.mean_completed_run_s == 246
    assert (figures.attempts, figures.not_run, figures.aborted, figures.completed) == (1, 0, 0, 1)
    assert figures.is_first_try


def test_the_selections_of_the_thesis_that_are_printed_are_taken_as_it_took_them():  # R-H02
    _, selections = measured(THESIS.read_text())
    by_hand = [5, 4, 5, 4, 2, 15, 5, 4, 4, 4, 10, 6, 5]
    assert [selection.seconds for selection in selections] == by_hand
    assert selections[5].icon == "closegripC"


def test_each_figure_of_a_task_by_hand():  # R-H02
    log = LogText().start().new(5)
    log.select(3, "cmoveC").select(4, "jmoveC").insert(2)  # the first selection led to nothing: 7 s for one
    log.select(6).insert(1).insert(2)  # the third insertion is without selection
    log.select(20).insert(3)  # a pause of 20 s
    log.delete(5, 3, 4).put(1, "undo", "Untitled-1", "a1", "deletes", "k", "appl")
    log.put(2, "try_insert_icon", "x", "x", "Start", "a1/0", "appl")
    log.run(8, 40, "a box fell").select(4).insert(2).put(2, "try_run_appl").select(3).insert(2).run(9, 50).quit()
    figures, selections = measured(log.text)
    assert [s.seconds for s in selections] == [7, 6, 20, 4, 3]
    assert (figures.selections, figures.all_selections) == (5, 6)
    assert figures.selection_s == 40
    assert figures.mean_selection_s == 8
    assert figures.selection_spread_s == pytest.approx(math.sqrt((1 + 4 + 144 + 16 + 25) / 4))
    assert (figures.insertions, figures.unselected, figures.unselected_s) == (6, 1, 2)
    assert figures.insertion_s == 2 + 1 + 2 + 3 + 2 + 2
    assert figures.mean_insertion_s == 2
    assert (figures.deletions, figures.undone, figures.refused) == (2, 1, 1)
    assert figures.check_s == (2 + 8) + 2 + 9  # from the undoing, and from the insertions
    assert (figures.attempts, figures.not_run, figures.aborted, figures.completed) == (3, 1, 1, 1)
    assert (figures.run_s, figures.completed_run_s) == (90, 50)
    assert figures.other_s == 5 + 1
    assert (figures.pauses, figures.pause_s, figures.longest_pause_s) == (1, 20, 20)
    assert figures.building_s == 40 + 12 + 21 + 6
    assert figures.elapsed_s == figures.building_s + 90
    assert figures.has_succeeded
    assert not figures.is_first_try


def test_who_never_succeeds_has_no_time_but_selections():  # R-H02
    figures, _ = measured(LogText().start().new().select(4).insert(2).run(5, 10, "stopped").quit().text)
    assert math.isnan(figures.elapsed_s)
    assert math.isnan(figures.building_s)
    assert figures.mean_selection_s == 4
    assert not figures.is_first_try


def test_a_break_between_sessions_is_not_counted():  # R-H02
    log = LogText().start().new().select(4).insert(2).quit().put(3600, "Start_Onika").select(4).insert(2).run(5, 10)
    figures, _ = measured(log.quit().text)
    assert figures.elapsed_s == 4 + 2 + 1 + 4 + 2 + 5 + 10
    assert figures.longest_pause_s == 0


def test_a_success_whose_end_is_not_in_the_log_has_a_time_of_building_only():  # R-H02
    log = LogText().start().new().select(4).insert(2).put(5, "run_appl").put(300, "open_view")
    figures, _ = measured(log.text, 1)
    assert math.isnan(figures.elapsed_s)
    assert figures.building_s == 11
    assert figures.run_s == 0


def test_nothing_comes_to_nothing():  # R-H02
    figures, selections = measured("")
    assert selections == ()
    assert figures.insertions == 0
    assert math.isnan(figures.mean_selection_s)
    assert {field.name for field in fields(TaskMeasures)} >= {"pauses", "check_s"}


EVENTS = st.sampled_from(("select", "insert", "delete", "new", "run", "run badly", "try", "undo", "view", "stray"))


@given(st.lists(st.tuples(EVENTS, st.integers(0, 60)), max_size=40))
def test_the_parts_of_the_time_add_up_whatever_happens(events):  # R-H02
    log = LogText(1000.0).start().new()
    for event, after in events:
        match event:
            case "delete":
                log.delete(after, 1)
            case "run":
                log.run(after, 7)
            case "run badly":
                log.run(after, 3, "stopped")
            case "select" | "insert" | "new":
                getattr(log, event)(after)
            case _:
                name = {"try": "try_run_appl", "undo": "undo", "view": "open_view", "stray": "run_appl"}[event]
                log.put(after, name, "x", "a1", "none", "0", "appl")
    log.run(1, 2)
    parsed, _ = logs.read(log.text, "x")
    task, _ = task_of(parsed)
    figures, _ = measure(task)
    of = figures
    parts = of.request_s + of.selection_s + of.insertion_s + of.check_s + of.run_s + of.other_s
    assert parts == pytest.approx(of.elapsed_s)
    assert parts == pytest.approx(task.entries[-1].at_s - task.entries[0].at_s)
    assert min(of.selection_s, of.insertion_s, of.check_s, of.run_s, of.other_s, of.building_s) >= -1e-6
    assert of.selections <= of.all_selections
    assert of.selections + of.unselected == of.insertions


def test_the_panel_of_a_new_application_is_its_request():  # R-H02
    log = LogText().start().put(3.0, "open_view", "newApplication", "0", "none", "0", "main")
    log.put(1.5, "type_value", "How many flows", "f", "2", "0", "appl").new(0.5)
    log.put(0.1, "close_view", "newApplication", "0", "none", "0", "main").select(2.0).insert(1.0).run(1.0, 4.0).quit()
    figures, _ = measured(log.text)
    assert (figures.request_s, figures.selection_s, figures.other_s) == (2.0, 2.0, pytest.approx(0.1))
    assert figures.elapsed_s == pytest.approx(10.1)


def test_a_panel_that_was_closed_asked_for_nothing():  # R-H02
    log = LogText().start().put(3.0, "open_view", "newApplication", "0", "none", "0", "main")
    log.put(9.0, "close_view", "newApplication", "0", "none", "0", "main").new(1.0)
    figures, _ = measured(log.select(2.0).insert(1.0).run(1.0, 4.0).quit().text)
    assert figures.request_s == 0.0
    assert figures.elapsed_s == pytest.approx(8.0)


def test_times_are_those_that_the_log_writes_and_no_noise_of_their_size():  # R-H02
    text = LogText().start().new().select(0.065).insert(0.143).run(1.0, 0.2).quit().text
    figures, (selection,) = measured(text)
    assert (selection.seconds, figures.insertion_s) == (0.065, 0.143)
    assert (figures.check_s, figures.completed_run_s) == (1.0, 0.2)
