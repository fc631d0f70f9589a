import pytest

from onika.desk.run.wait_condition import WaitCondition


@pytest.mark.parametrize(
    ("condition", "sentence"),
    [
        (WaitCondition("seconds", seconds=2.5), "2.5 s"),
        (WaitCondition("began", "flow0", 2), "action 3 of flow0 has begun"),
        (WaitCondition("done", "flow0", 0), "action 1 of flow0 is done"),
        (WaitCondition("paused", "flow1"), "flow1 is paused"),
        (WaitCondition("paused"), "every flow is paused"),
        (WaitCondition("done"), "every flow is done"),
        (WaitCondition("waiting"), "a flow waits"),
        (WaitCondition("stopped", "flow0"), "flow0 has stopped"),
    ],
)
def test_a_moment_says_what_it_is(condition, sentence):  # R-E07
    assert str(condition.sentence) == sentence
