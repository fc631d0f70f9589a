"""Applications run by the acts of a page, on a real runtime in scaled time (E07, E08, E10 to E15, X06)."""

import contextlib
import os
import queue
import signal
import time

import pytest

from kit.labs.laboratory import Laboratory, job, joints, target
from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.runtime_thread import RuntimeThread
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.world_channel import WorldChannel
from onika.store.library import open_libraries
from onika.store.site import open_site
from onika.wire import act
from onika.wire.view import ShowValues

pytestmark = pytest.mark.site

PATIENCE_S = 60.0
BRITTLE = '''
from onika.module import Module, ModuleError, finish

class Brittle(Module):
    """Fails at its first activation, and then no more."""

    trigger = True
    _times = 0

    def on(self, inputs):
        self._times += 1

    def cycle(self):
        if self._times < 2:
            raise ModuleError("the glass is broken")
        return finish()
'''

LETHAL = """
import os, signal
from onika.module import Module, finish

class Lethal(Module):
    \"\"\"Takes its unit with it.\"\"\"

    trigger = True

    def cycle(self):
        os.kill(os.getpid(), signal.SIGKILL)
"""


def pause(name, seconds, *marks):
    return [job("pauseC", "Pause job", *marks), target(name, "Pause object", str(seconds))]


class Page:
    """The environment and a runtime of its own, in scaled time, with an application of this laboratory open."""

    def __init__(self, folder, *, is_virtual=True):
        self.files = Laboratory(folder)
        self.folder = folder
        site = open_site([folder], {}, None)
        self.things = queue.Queue()
        self.says = []
        options = ("--scale", "4") if is_virtual else ()
        launching = RuntimeLauncher(("rt0",), is_virtual=is_virtual, with_fifo=False, options=options)
        self.station = RuntimeThread(launching, self.things.put)
        syntax, _ = site.syntax()
        model = Model(OpenLibraries(open_libraries(site.directories)), syntax=syntax)
        self.environment = Environment(
            model, HANDLERS, Services(site, time.monotonic), WorldChannel(self.station, site)
        )
        self.environment.listeners.append(self)
        self.station.begin(self.environment)
        self.values = {}

    def patch(self, patch):
        pass

    def say(self, say):
        self.says.append(say)

    def open(self, *flows, name="play", parallel=False):
        path = self.files.application(name, *flows, parallel=parallel)
        return self.do(act.Open(str(path)))

    def answer(self, wish):
        given = []
        self.environment.do(wish, "me", given.append)
        self.until(lambda: given)
        return given[0]

    def do(self, wish):
        answer = self.answer(wish)
        assert answer.no is None, answer.no
        return answer.value

    def until(self, reached):
        end = time.monotonic() + PATIENCE_S
        while not reached():
            assert time.monotonic() < end, f"it did not come; {self.run}; {[say.text for say in self.says[-5:]]}"
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()
            frame = self.station.frame()
            if frame is not None:
                self.values |= frame.values | {f"world:{name}": rows for name, rows in frame.poses.items()}

    @property
    def run(self):
        return self.environment.tree.run

    def flow(self, name="flow0"):
        return self.run.flows[name]

    def is_in(self, state, name="flow0"):
        self.until(lambda: self.flow(name).state == state)

    def ends(self):
        self.until(lambda: self.run.state == "over")
        return self.run


@pytest.fixture
def page(tmp_path):
    page = Page(tmp_path)
    yield page
    page.station.end()


def test_an_application_runs_to_its_end_and_a_second_time(page):  # R-E07, R-E11, R-E14
    steps = [job("jmoveC", "Joint job"), joints("there", 0.3, -1.5, 1.5, 0, 0, 0, duration=4.0), *pause("rest", 0.5)]
    doc = page.open(steps)
    page.station.watch(frozenset((f"{doc}/Q_MEZ", f"{doc}/flow0/Q_REF")), frozenset(("boxes",)), False, 30.0)
    assert page.do(act.Run(doc)) == 1
    assert page.environment.tree.applications[doc].is_running
    page.until(lambda: page.flow().step == 1)
    assert page.flow().should_take_s == 4.0 and page.flow().action == "a job a target"
    run = page.ends()
    assert run.is_completed and (run.done, run.of) == (2, 2) and run.took_s > 4.5
    assert [(key, step.state, step.times) for key, step in run.steps.items()] == [("1", "done", 1), ("3", "done", 1)]
    assert 3.9 < run.steps["1"].took_s < 4.3
    assert page.says[-1].level == "success"
    page.until(lambda: abs(page.values.get(f"{doc}/Q_MEZ", [0.0])[0] - 0.3) < 0.02 and "world:boxes" in page.values)
    assert f"{doc}/flow0/Q_REF" in page.values and page.environment.tree.runtime.worlds == {"boxes": True}
    page.until(lambda: not page.environment.tree.applications[doc].is_running)
    assert page.do(act.Run(doc)) == 2
    assert page.ends().is_completed
    page.do(act.Dismiss())
    assert page.run is None


def test_a_run_is_paused_stepped_skipped_and_marked(page):  # R-E07, R-E13
    doc = page.open([*pause("one", 8), *pause("two", 1), *pause("three", 600), *pause("four", 0.2)])
    page.do(act.Run(doc))
    page.do(act.Steer("pause"))
    page.until(lambda: page.flow().is_pausing)
    page.is_in("paused")
    assert page.flow().step == 1 and not page.flow().is_pausing
    page.do(act.Steer("step"))
    page.until(lambda: page.flow().state == "paused" and page.flow().step == 3)
    page.do(act.Steer("continue"))
    page.until(lambda: page.flow().step == 5)
    assert str(page.answer(act.Steer("dance")).no.reason).startswith("expected one of pause")
    page.do(act.SkipTo(8))  # the target of the last one
    run = page.ends()
    assert run.is_completed and run.steps["5"].state == "left" and run.steps["5"].times == 0
    assert run.steps["7"].state == "done" and run.done == 3


def test_a_breakpoint_that_is_set_meanwhile_counts_at_once(page):  # R-D06, R-E07
    doc = page.open([*pause("one", 12), *pause("two", 0.5)])
    page.do(act.Run(doc))
    page.do(act.SetBreakpoint(doc, (1,)))
    page.is_in("paused")
    assert page.flow().step == 1
    page.do(act.Steer("continue"))
    assert page.ends().is_completed
    page.do(act.Run(doc, passes_breakpoints=True))
    assert page.ends().is_completed


def test_a_stop_is_explained_and_cleared(page):  # R-E08, R-X06
    page.files.module("brittle", BRITTLE)
    page.files.plain_task("brittle", hz=50)
    page.files.configuration("brittleC", "brittle 50")
    doc = page.open([*pause("one", 0.2), job("brittleC"), *pause("two", 0.2)])
    page.do(act.Run(doc))
    page.until(lambda: "flow0" in page.run.stops)
    stop = page.run.stops["flow0"]
    assert "the glass is broken" in str(stop.text) and (stop.kind, stop.step, stop.task) == ("error", 3, "brittle")
    assert "ModuleError" in stop.traceback and page.flow().state == "stopped"
    verbs = [choice.verb for choice in stop.choices]
    assert verbs == ["clear", "next", "skip", "abort"] and stop.choices[2].act is None
    page.do(stop.choices[0].act)
    run = page.ends()
    assert run.is_completed and run.stops == {} and run.steps["3"].times == 1


def test_a_question_is_answered_in_mid_run(page):  # R-D16, R-E15
    doc = page.open([job("pauseC", "Odd job")])
    page.do(act.Run(doc))
    page.until(lambda: page.run.asks)
    assert [item.name for item in page.run.asks["flow0/pause"].items] == ["duration"]
    page.do(act.Answer(doc, "flow0/pause", "long"))
    page.until(lambda: page.run.asks and page.run.asks["flow0/pause"].reason)
    page.do(act.Answer(doc, "flow0/pause", "0.2"))
    assert page.ends().is_completed and page.run.asks == {}


def test_a_question_offers_where_the_arm_stands(page):  # R-C13, R-E15
    doc = page.open([*pause("first", 60), job("jmoveC", "Odd job")])
    page.do(act.Run(doc))
    page.until(lambda: "jtraj" in page.environment.model.libraries.sheets)
    page.do(act.Steer("next"))
    page.until(lambda: page.run.asks.get("flow0/jtraj") is not None and page.run.asks["flow0/jtraj"].present)
    assert len(page.run.asks["flow0/jtraj"].present["endpoint"]) == 6
    page.do(act.Steer("abort"))
    assert page.ends().asks == {}


def test_two_flows_meet_and_tell_who_waits_for_whom(page):  # R-E04, R-X03
    program = [*pause("long", 12), *pause("there", 0.2, "SYNCHTAG    meet")]
    two = pause("here", 0.2, "SYNCHTAG    meet")
    doc = page.open(program, two, parallel=True)
    page.do(act.Run(doc))
    page.is_in("waiting", "flow1")
    assert page.flow("flow1").waits_for == ("flow0",) and page.flow("flow1").tag == "meet"
    run = page.ends()
    assert run.is_completed and run.meets[0].tag == "meet" and set(run.meets[0].flows) == {"flow0", "flow1"}


def test_loops_are_counted_and_left(page):  # R-E05, R-E07
    test = job("repeatC", "Number job", "WHILETAG    round", "WHILETEST   yes")
    flow = [*pause("in", 0.2, "WHILETAG    round", "WHILETEST   no"), test, target("often", "Number object", "500")]
    doc = page.open(flow)
    page.do(act.Run(doc))
    page.until(lambda: page.run.steps["1"].times > 1 if "1" in page.run.steps else False)
    page.until(lambda: page.flow().loops == ("round",))
    page.do(act.Steer("leave"))
    run = page.ends()
    assert run.is_completed and run.steps["1"].times == run.steps["3"].times > 1


def test_everything_is_stopped_and_nothing_runs_before_a_reset(page):  # R-E07, law 27
    doc = page.open(pause("long", 600))
    page.do(act.Run(doc))
    page.do(act.Stop())
    run = page.ends()
    assert not run.is_completed and "Stop was pressed" in str(run.cause) and run.steps["1"].state == "left"
    refused = page.answer(act.Run(doc)).no
    assert refused.remedies[0].act == act.Reset()
    page.do(act.Reset())
    page.do(act.Run(doc))
    page.do(act.Steer("abort"))
    assert str(page.ends().cause) == "aborted by the user"


def test_a_runtime_that_is_killed_aborts_the_run_and_another_takes_over(page):  # R-E10
    doc = page.open(pause("long", 600))
    page.do(act.Run(doc))
    page.until(lambda: page.flow().step == 1)
    os.kill(page.station.pid, signal.SIGKILL)
    run = page.ends()
    assert not run.is_completed and "the runtime is lost" in str(run.cause)
    assert page.environment.tree.runtime.state == "lost"
    assert page.do(act.Run(doc)) == 2
    page.do(act.Steer("abort"))
    page.ends()


def test_what_lives_in_the_way_is_named_and_ended_only_if_the_user_wants_it(page):  # reading 30, R-E12
    other = page.do(act.New())
    page.do(act.Connect(other))
    page.do(act.Place(other, "puma", 0, 0))
    live = page.environment.tree.documents
    page.until(lambda: page.environment.tree.documents[other].tasks["puma"].state == "OFF")
    beside = page.do(act.New())
    page.do(act.Connect(beside, subsystem="apart"))
    page.do(act.Place(beside, "repeat", 0, 0))
    page.until(lambda: page.environment.tree.documents[beside].tasks["repeat"].state == "OFF")
    doc = page.open([job("jmoveC", "Joint job"), joints("there", 0.1, -1.5, 1.5, 0, 0, 0, duration=0.5)])
    refused = page.answer(act.Run(doc)).no
    assert f"puma of {live[other].name}" in str(refused.reason) and "repeat" not in str(refused.reason)
    assert page.run is None
    page.do(refused.remedies[0].act)
    assert page.environment.tree.documents[other].connection == "none"
    assert page.ends().is_completed
    assert page.environment.tree.documents[beside].tasks["repeat"].state == "OFF"


def test_starting_anew_gives_a_new_workcell(page):  # R-X10
    doc = page.open(pause("long", 600))
    page.do(act.Run(doc))
    former = page.station.pid
    refused = page.answer(act.StartAnew()).no
    assert "play" in str(refused.reason)
    page.do(refused.remedies[0].act)
    assert page.station.pid != former and page.run.state == "over" and "anew" in str(page.run.cause)
    page.do(act.Run(doc))
    page.do(act.Steer("abort"))
    page.ends()


def test_a_unit_that_dies_ends_the_run_and_a_new_runtime_is_offered(tmp_path):  # R-E10, R-X06
    page = Page(tmp_path, is_virtual=False)
    try:
        page.files.module("lethal", LETHAL)
        page.files.plain_task("lethal", hz=50)
        page.files.configuration("lethalC", "lethal 50")
        doc = page.open([job("lethalC")])
        page.do(act.Run(doc))
        run = page.ends()
        assert not run.is_completed and "rt0" in str(run.cause) and run.stops[""].kind == "lost"
        page.until(lambda: page.environment.tree.runtime.units["rt0"].is_lost)
        refused = page.answer(act.Run(doc)).no
        assert "rt0" in str(refused.reason)
        page.do(refused.remedies[0].act)
        assert not page.environment.tree.runtime.units["rt0"].is_lost
        assert page.do(act.Run(page.open(pause("short", 0.2), name="other"))) == 2
        assert page.ends().is_completed
    finally:
        page.station.end()


def test_what_the_runtime_finds_wrong_names_its_step(page):  # R-E01
    doc = page.open([*pause("fine", 0.1), *pause("endless", 1e9)])
    refused = page.answer(act.Run(doc)).no
    assert "duration" in str(refused.reason)
    assert refused.remedies[0].show == ShowValues(4) and page.run is None  # the target
