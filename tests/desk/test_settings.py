from onika.desk.settings import Elsewhere, RunSettings


def test_a_run_is_as_usual_unless_said_otherwise():  # R-E01, R-E08, R-E10
    found = RunSettings("go_home")
    assert (found.on_loss, found.on_error, found.script) == ("stop", "abort", None)
    assert (found.is_virtual, found.settle_s, found.seed) == (False, 0.5, 0)


def test_a_runtime_elsewhere_needs_no_more_than_its_address():  # R-F01
    assert (Elsewhere("ws://127.0.0.1:7994").token, Elsewhere("ws://127.0.0.1:7994").ca) == ("", None)
