"""A subsystem that is held by hand is recorded by real processes (requirement X05)."""

import pytest

from kit.plans.plan_builder import PlanBuilder
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.run_review import Review
from onika.wire import event, live, request

pytestmark = pytest.mark.site

COUNTER = """
from onika.module import Module, OutVar

class Counter(Module):
    COUNT = OutVar("double", "-", "how many cycles")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
"""
_TURNS = 600


def count_to(runtime, least, is_virtual):
    """Let the task cycle until it has counted so far."""
    for _ in range(_TURNS):
        if is_virtual:
            runtime.ask(live.Advance(0.1))
        list(runtime.events(0.05))
        if runtime.ask(live.Read("jog", ("COUNT",))).values["COUNT"] >= least:
            return
    raise AssertionError(f"it never counted to {least}")


@pytest.mark.parametrize("is_virtual", [True, False])
def test_every_cycle_of_what_is_on_by_hand_is_in_the_file(tmp_path, is_virtual):  # R-X05, law 29
    path, again = tmp_path / "jog.mcap", tmp_path / "again.mcap"
    shop = PlanBuilder()
    shop.task("counter", COUNTER, frequency=100.0)
    with LaunchedRuntime(("rt0",), is_virtual=is_virtual) as runtime:
        runtime.ask(live.Attend(("*",)))
        assert runtime.ask(live.Record("jog", str(path))).reason.key == "host.nothing_to_record"
        on = (live.Turn("counter"),)
        runtime.ask(live.Change("jog", spawn=(shop.planned("counter"),), code=(shop.code("counter"),), on=on))
        count_to(runtime, 20, is_virtual)
        assert runtime.ask(live.Record("jog", str(path))) == request.Done()
        count_to(runtime, 100, is_virtual)
        assert runtime.ask(live.Record("jog")) == request.Done()
        told = [message for message in runtime.events(0.2) if isinstance(message, event.Recording)]
        assert not told or not told[-1].is_on
        assert runtime.ask(live.Record("jog", str(again))) == request.Done()
        count_to(runtime, 150, is_virtual)
    with Review(path) as review:
        assert review.is_whole and review.run.is_by_hand and review.ending["missed"] == "0"
        counts = [count for _, count in review.series["jog/COUNT"].values()]
        assert counts[0] >= 20 and counts[-1] >= 100
        assert counts == [counts[0] + k for k in range(len(counts))]
        assert review.at(review.span_s[1]).tasks["jog/counter"] == "ON"
    with Review(again) as review:  # the runtime ended first
        assert review.is_whole and review.series["jog/COUNT"].at(1 << 62) >= 150
