import runpy
import time
from dataclasses import replace
from pathlib import Path

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.desk.environment.show.tree import Projector
from onika.desk.environment.show.wiring import MadeDocument, group_views, locus_views, placed_views
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import SubsystemFacts, TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Group, Placed
from onika.model.rules import loci
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import Library
from onika.wire import act
from onika.wire.view import DocumentView, GroupView

BENCH = runpy.run_path(str(Path(__file__).parents[4] / "tools" / "bench" / "canvas.py"))

TASKS = (
    Task("a", "a", outvar=("P",), outconst=("K",)),
    Task("b", "b", invar=("P",), inconst=("K",), outvar=("Q",)),
    Task("c", "c", inconst=("P",), invar=("P", "Q")),
    Task("d", "d", invar=("Q",), aliases=(("Q", "P"),)),
)
LIBRARIES = OpenLibraries((Library(BaseDirectory("x"), {task.name: RmodText(task) for task in TASKS}, ()),))
OTHER = LIBRARIES.edited({"d": replace(TASKS[3], aliases=())})
FEWER = OpenLibraries((Library(BaseDirectory("x"), {task.name: RmodText(task) for task in TASKS[:3]}, ()),))

facts = st.dictionaries(st.sampled_from("abcd"), st.sampled_from(["ON", "OFF", "ERROR"]).map(TaskFacts))
lives = st.none() | st.builds(SubsystemFacts, st.just("s"), st.sampled_from(["connecting", "live", "lost"]), facts)
spots = st.permutations("abcde").flatmap(
    lambda names: st.lists(st.tuples(st.integers(0, 2), st.booleans()), max_size=5).map(
        lambda places: tuple(Placed(name, 300 * x, 0, left) for name, (x, left) in zip(names, places, strict=False))
    )
)
libraries_examples = st.sampled_from([LIBRARIES, OTHER, FEWER])


def document(placed, live, libraries, former=None):
    """A document after `former`, whose tasks and loci are the same objects where they are the same."""
    before = former.content.configuration if former else Configuration("c")
    former = {placement: placement for placement in before.placed}
    configuration = replace(before, placed=tuple(former.get(placement, placement) for placement in placed))
    boxes = libraries.boxes(tuple(placement.task for placement in placed))
    return Document("c1", Content(loci.settled(configuration, boxes, before)), live=live)


def cpu_s(work):
    """How long this process computes: what else the machine does is no part of it."""
    began = time.process_time()
    work()
    return time.process_time() - began


@given(st.lists(st.tuples(spots, lives, libraries_examples), min_size=1, max_size=5))
@settings(max_examples=examples(150), deadline=None)
def test_what_is_shown_is_what_it_would_be_made_anew(states):  # R-C09, R-C25
    seen = None
    for placed, live, libraries in states:
        now = document(placed, live, libraries, seen and seen.document)
        tasks, lines = placed_views(now, libraries, seen), locus_views(now, libraries, seen)
        assert tasks == placed_views(now, libraries, None)
        assert lines == locus_views(now, libraries, None)
        seen = MadeDocument(now, libraries, DocumentView("c", 0, tasks=tasks, loci=lines))


def test_a_line_is_live_where_its_writer_is_on_and_stale_where_it_failed():  # R-C25
    placed = (Placed("a"), Placed("b"), Placed("gone"))
    states = {"a": TaskFacts("ON"), "b": TaskFacts("ERROR")}
    live = document(placed, SubsystemFacts("s", "live", states), LIBRARIES)
    views = locus_views(live, LIBRARIES, None)
    assert {svar: view.line for svar, view in views.items()} == {"K": "live", "P": "live", "Q": "stale"}
    assert (views["P"].writers, views["P"].readers, views["K"].is_constant) == (("a",), ("b",), True)
    assert placed_views(live, LIBRARIES, None)["gone"].is_missing
    idle = locus_views(document(placed, SubsystemFacts("s", "lost", states), LIBRARIES), LIBRARIES, None)
    assert {view.line for view in idle.values()} == {"idle"}


def test_one_task_that_moves_is_the_only_new_object():
    before = document((Placed("a"), Placed("b")), None, LIBRARIES)
    tasks, lines = placed_views(before, LIBRARIES, None), locus_views(before, LIBRARIES, None)
    seen = MadeDocument(before, LIBRARIES, DocumentView("c", 0, tasks=tasks, loci=lines))
    configuration = before.content.configuration
    moved = replace(configuration, placed=(Placed("a", 50), configuration.placed[1]))
    now = before.having(Content(moved))
    assert locus_views(now, LIBRARIES, seen) is lines
    views = placed_views(now, LIBRARIES, seen)
    assert views["a"].x == 50
    assert views["b"] is tasks["b"]
    assert placed_views(before, LIBRARIES, seen) is tasks


def test_acts_are_quick_on_a_large_canvas(tmp_path):  # R-C07: a thousand tasks in the library, 500 placed
    large = BENCH["Large"](tmp_path, 1_000)
    rounds = range(7)
    place, undo = act.Place("c1", large.free, 37, 41), act.Undo("c1")
    both = min(cpu_s(lambda: (large.do(place), large.do(undo))) for _ in rounds)
    anew = min(cpu_s(lambda: Projector().project(large.environment.model)) for _ in rounds)
    assert 2 * both < anew, "an act and what takes it back make nearly everything anew"


@given(st.lists(lives, min_size=2, max_size=5))
@settings(max_examples=examples(60), deadline=None)
def test_lines_follow_the_states_of_their_writers(states):  # R-C25
    placed, seen = tuple(Placed(name) for name in "abcd"), None
    for live in states:
        now = document(placed, live, LIBRARIES, seen and seen.document)
        tasks, lines = placed_views(now, LIBRARIES, seen), locus_views(now, LIBRARIES, seen)
        assert (tasks, lines) == (placed_views(now, LIBRARIES, None), locus_views(now, LIBRARIES, None))
        seen = MadeDocument(now, LIBRARIES, DocumentView("c", 0, tasks=tasks, loci=lines))


def test_supermodules_are_shown_and_those_that_stay_are_the_same_objects():  # R-C17
    plain = document((Placed("a"), Placed("b"), Placed("c")), None, LIBRARIES)

    def grouped(*groups):
        return plain.having(replace(plain.content, configuration=replace(plain.content.configuration, groups=groups)))

    first = grouped(Group("one", ("b", "a")))
    shown = group_views(first, None)
    assert shown == {"one": GroupView(("b", "a"))}
    seen = MadeDocument(first, LIBRARIES, DocumentView("c", 0, groups=shown))
    assert group_views(first, seen) is shown
    more = group_views(grouped(Group("one", ("b", "a")), Group("two", ("c",))), seen)
    assert more["one"] is shown["one"] and more["two"] == GroupView(("c",))
