import pytest

from onika.wire.hand_over import HandOver, hand_over_in, line_of


def test_a_line_says_how_a_runtime_is_reached():  # R-A15
    said = HandOver(4711, "token", 12, is_new=False)
    assert hand_over_in(line_of(said)) == said
    assert "\n" not in line_of(said)


@pytest.mark.parametrize(
    "line",
    [
        "", "Welcome to robot", "{}", '{"onika":"other","port":1,"token":"t","process":1}', '{"onika":"hand-over"}',
        '{"onika":"hand-over","port":0,"token":"t","process":1}', '{"onika":"hand-over","port":70000,"token":"t"}',
    ],
)  # fmt: skip
def test_what_a_machine_says_besides_is_no_hand_over(line):  # R-A15
    assert hand_over_in(line) is None


def test_what_a_newer_one_says_more_does_no_harm():  # R-A15
    line = '{"onika":"hand-over","port":1,"token":"t","process":2,"fingerprint":"x"}'
    assert hand_over_in(line) == HandOver(1, "t", 2)
