import struct

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.model.task import Task
from onika.wire import act
from onika.wire.samples import Sample, Sampled, SampleStretch, SampleTrace
from onika.words.reason import Reason

TASKS = (Task("a", "a", outvar=("A",), frequency=10.0),)
MS = 1_000_000


@pytest.fixture
def solo(tmp_path):
    return FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())


def test_values_at_every_cycle_come_with_their_times_and_losses_are_counted(solo):  # R-C14
    doc = solo.connected("a")
    stretches = (SampleStretch(5, 2 * MS, 2 * MS, 2), SampleStretch(10, 12 * MS, 2 * MS, 1))
    values = struct.pack("6d", 1, 2, 3, 4, 5, 6)
    solo.rebuffs = {Sample: Sampled(0, (SampleTrace("Untitled-1/A", "double[2]", stretches, values),))}
    (view,) = solo.do(act.SampleVariables((f"{doc}/A",), (4,)))
    assert solo.carried_out[-1] == Sample(("Untitled-1/A",), (4,))
    assert (view.variable, view.last, view.missed, view.reason) == (f"{doc}/A", 10, 3, None)
    assert view.labels == ("A[0]", "A[1]")
    assert view.at_s == pytest.approx((0.002, 0.004, 0.012))
    assert view.rows == ((1, 2), (3, 4), (5, 6))


def test_a_variable_that_goes_says_why_and_its_number_stays(solo):  # R-C14
    doc = solo.connected("a")
    gone = Reason.of("host.not_sampled_there", name="A")
    solo.rebuffs = {Sample: Sampled(0, (SampleTrace("Untitled-1/A", reason=gone),))}
    (view,) = solo.do(act.SampleVariables((f"{doc}/A",), (7,)))
    assert (view.last, view.reason, view.rows) == (7, gone, ())


def test_what_is_not_connected_has_no_values_at_every_cycle(solo):
    assert solo.no(act.SampleVariables(("none/A",))).reason.key == "desk.not_sampled"
    assert solo.no(act.SampleVariables(())).reason.key == "desk.not_sampled"
