"""An environment that looks at recordings of runs that never were: each action of an application takes a second.

env = ReviewFixture(tmp_path)
doc = env.open([job("aC"), job("bC")])
path = env.film(doc)
env.look(path)
assert env.glance(1.5).run.flows["flow0"].step == 2

In flow0 the variable A counts the seconds, ten times in each; in world `yard` body 1 moves, and its lamp shines from
1 s on.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from kit.desk.run_fixture import RunFixture
from kit.record.recording_builder import RecordingBuilder
from onika.desk.environment.runs.begin import ready
from onika.record import foxglove, topics
from onika.record.run import RunRecord
from onika.wire import act, event, request
from onika.wire.view import InstantView, RecordingView
from onika.words.reason import NOTHING
from onika.words.shape import Shape

LAMP = {
    "name": "lamp", "body": 1, "kind": "sphere", "size": (0.1, 0.0, 0.0), "position": (0.0, 0.0, 0.0),
    "quaternion": (1.0, 0.0, 0.0, 0.0), "rgba": (0.1, 0.2, 0.3, 1.0), "paint": "glow",
}  # fmt: skip
BEGAN = "2026-11-21T23:15:00.000+00:00"


class ReviewFixture(RunFixture):
    """`look` and `glance` do what a page does."""

    def film(
        self,
        doc: str,
        name: str = "film",
        *,
        step: float = 1.0,
        ends: bool = True,
        held_s: tuple[float, float] | None = None,
    ) -> Path:
        """A recording of an open application as it is now; `step` is by how much A grows in a second."""
        tape = self.tape(doc, name, held_s)
        for number, flow in enumerate(tape.plan.flows):
            self._act(tape, number, len(flow.actions))
        count = max(len(flow.actions) for flow in tape.plan.flows)
        tape.variable("A", "double", *((k / 10, step * k / 10) for k in range(10 * count)), unit="s")
        tape.variable("WORD", "string", (0.0, b"on".ljust(Shape.parse("string").size, b"\0")))
        self._draw(tape, count)
        if ends:
            result = event.Result(True, NOTHING, count, count, float(count), 0.0, {}, (), "")
            tape.tell(float(count), result, "")
            tape.end(completed="yes", cause="")
        else:
            tape.cut()
        return tape.path

    def tape(self, doc: str, name: str = "film", held_s: tuple[float, float] | None = None) -> RecordingBuilder:
        """An empty recording of an open application as it is now, or a black box that holds so much of it."""
        syntax, opened = self.environment.model.syntax, self.environment.model.applications[doc]
        plan = ready(opened, self.site, syntax).plan if syntax is not None else None
        if plan is None:
            raise AssertionError(f"{doc} cannot be compiled")
        run = RunRecord(
            request.Prepare(plan, ()), request.Begin(), ("rt0",), is_virtual=True, is_fresh=True, began=BEGAN
        )
        return RecordingBuilder(self.base.path / f"{name}.mcap", run, held_s)

    def look(self, path: Path) -> RecordingView:
        """Look at a recording; what is shown of it."""
        answer = self.later(act.OpenRecording(str(path)))
        if answer.no is not None or self.environment.tree.review is None:
            raise AssertionError(f"{path} is not looked at: {answer.no}")
        return self.environment.tree.review.recording

    def glance(self, at_s: float, *, of_other: bool = False) -> InstantView:
        """What it was like then."""
        instant_view: InstantView = self.do(act.Glance(at_s, of_other))
        return instant_view

    def _act(self, tape: RecordingBuilder, flow: int, count: int) -> None:
        home, actions = tape.plan.flows[flow].subsystem, tape.plan.flows[flow].actions
        tape.tell(0.0, event.Moved(home, "running", 0, 0.0), home)
        for index, action in enumerate(actions):
            tape.tell(float(index), event.Began(flow, index, count, action.name, float(index)), home)
            tape.tell(float(index), event.TaskState(home, action.tasks[0], "ON", float(index)), home)
            tape.tell(index + 1.0, event.TaskState(home, action.tasks[0], "OFF", index + 1.0), home)
            tape.tell(index + 1.0, event.Done(flow, index, index + 1.0), home)

    def _draw(self, tape: RecordingBuilder, seconds: int) -> None:
        tape.attach(topics.shapes("yard"), topics.encode([LAMP]))
        for at_s, lit in ((0.0, ()), (1.0, ("lamp",))):
            body = foxglove.scene("yard", 0, [LAMP], lit)
            tape.show(at_s, topics.scene("yard"), foxglove.SCENE, foxglove.SCENE_SCHEMA, body)
        for k in range(seconds):
            body = foxglove.frames("yard", 0, _rows([(0, 0, 0, 1, 0, 0, 0), (k, 0, 0, 1, 0, 0, 0)]))
            tape.show(float(k), topics.frames("yard"), foxglove.FRAMES, foxglove.FRAMES_SCHEMA, body)


def _rows(rows: Sequence[Sequence[float]]) -> bytes:
    return np.array(rows, dtype=np.float32).tobytes()
