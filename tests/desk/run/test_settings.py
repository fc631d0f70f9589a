from onika.desk.run.settings import RunSettings, RuntimeLocation
from onika.words.condition import Condition


def test_a_run_is_as_usual_unless_said_otherwise():  # R-E01, R-E08, R-E10
    settings = RunSettings("go_home")
    assert (settings.on_loss, settings.on_error, settings.script) == ("stop", "abort", None)
    assert (settings.is_virtual, settings.settle_s, settings.seed) == (False, 0.5, 0)


def test_a_runtime_elsewhere_needs_no_more_than_its_address():  # R-F01
    assert (RuntimeLocation("ws://127.0.0.1:7994").token, RuntimeLocation("ws://127.0.0.1:7994").ca) == ("", None)


def test_the_runtime_is_asked_for_what_it_has_to_know():  # R-E01, R-X07
    twice = (Condition.parse("LAMP == 1"), Condition.parse("LAMP > 0"))
    message = RunSettings("go_home", expectations=twice, on_error="wait", seed=3).begin(is_held=True)
    assert (message.watch, message.on_error, message.seed, message.is_held) == (("LAMP",), "wait", 3, True)
