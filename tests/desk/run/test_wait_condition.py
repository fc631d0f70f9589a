import pytest

from onika.desk.run.wait_condition import Moment


@pytest.mark.parametrize(
    ("moment", "sentence"),
    [
        (Moment("seconds", seconds=2.5), "2.5 s"),
        (Moment("began", "flow0", 2), "action 3 of flow0 has begun"),
        (Moment("done", "flow0", 0), "action 1 of flow0 is done"),
        (Moment("paused", "flow1"), "flow1 is paused"),
        (Moment("paused"), "every flow is paused"),
        (Moment("done"), "every flow is done"),
        (Moment("waiting"), "a flow waits"),
        (Moment("stopped", "flow0"), "flow0 has stopped"),
    ],
)
def test_a_moment_says_what_it_is(moment, sentence):  # R-E07
    assert str(moment) == sentence
