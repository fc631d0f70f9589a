import msgspec

from onika.wire import act


def test_nothing_goes_on_from_a_recording_or_is_replaced_unless_it_is_confirmed():
    assert msgspec.to_builtins(act.Continue(12.5)) == {"t": "Continue", "at_s": 12.5}
    assert not act.KeepTest("a1").confirmed


def test_how_far_two_runs_may_lie_apart_depends_on_them_unless_it_is_said():
    message = act.CompareWith("run.mcap", part=0.0)
    assert (message.tolerance, message.part, message.time_s) == (None, 0.0, None)
