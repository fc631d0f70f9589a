from types import SimpleNamespace

from onika.host.sessions.dependents import runs_of, subsystems_of


def test_silence_takes_from_nobody_a_run_that_was_begun_to_go_on():  # R-X12, R-X24
    ends, goes_on, other = (
        SimpleNamespace(session="one", on_loss="stop"),
        SimpleNamespace(session="one", on_loss="run"),
        SimpleNamespace(session="two", on_loss="stop"),
    )
    assert runs_of("one", [ends, goes_on, other], is_silent=True) == [ends]
    assert runs_of("one", [ends, goes_on, other], is_silent=False) == [ends, goes_on]


def test_what_a_session_holds_by_hand_comes_to_rest():  # R-X12, R-X24
    assert subsystems_of("one", {"main": "one", "side": "two", "free": ""}) == ["main"]
