import pytest

from onika.host.diagnosis.stop_cause import CauseKind, of_failure, of_loss, of_question, of_refusal, of_signal
from onika.runtime import news
from onika.runtime.user_input import AskedItem
from onika.words.reason import NOTHING, Reason


def in_call(task):
    return Reason.of("host.in_call", task=task)


def failed(text, entry="cycle"):
    return news.Failed("flow0", "puma", entry, text, "puma.py", 7, "trace", 5, values={"TAU_REF": [1.0]})


def test_a_failure_keeps_what_was_said_where_and_with_which_values():  # R-X06
    cause = of_failure(failed("ValueError: no"))
    assert (cause.kind, cause.subsystem, cause.task) == (CauseKind.ERROR, "flow0", "puma")
    assert (str(cause.text), cause.path, cause.line, cause.entry) == ("cycle: ValueError: no", "puma.py", 7, "cycle")
    assert cause.values == {"TAU_REF": [1.0]}
    assert not cause.ends


@pytest.mark.parametrize(
    ("why", "kind"),
    [
        (Reason.of("runtime.button_pressed"), CauseKind.PRESSED),
        (Reason.of("runtime.button_still_pressed"), CauseKind.PRESSED),
        (Reason.of("runtime.drive_tripped"), CauseKind.TRIPPED),
        (Reason.plain("no torque over a tripped panic button"), CauseKind.ERROR),
    ],
)
def test_a_hardware_task_that_fails_over_its_drive_is_told_apart(why, kind):  # R-X06, R-K06
    raised = Reason.of("runtime.raised", kind="ModuleError", why=why)
    assert of_failure(failed(raised), is_hardware=True).kind is kind
    assert of_failure(failed(raised), is_hardware=False).kind is CauseKind.ERROR


@pytest.mark.parametrize("kind", ["ILLEGAL", "SHUTDOWN"])
def test_a_signal_that_ends_the_run_is_a_cause(kind):  # R-A08, R-X06
    cause = of_signal(news.Signalled("flow0", "puma", kind, 0, Reason.plain("too hot"), 5))
    assert (cause.kind.name, str(cause.text), cause.task) == (kind, f"{kind}: too hot", "puma")


def test_other_signals_are_no_causes():  # R-X06
    with pytest.raises(ValueError, match="found LEGAL"):
        of_signal(news.Signalled("flow0", "puma", "LEGAL", 0, NOTHING, 5))


def test_a_refusal_names_the_command():  # R-X06
    cause = of_refusal(news.Refused("flow0", "puma", "on", Reason.plain("it is in ERROR")))
    assert str(cause.text) == "on is refused: it is in ERROR"


def test_a_question_names_what_is_asked_for_and_what_was_wrong():  # R-X06, law 25
    items = (AskedItem("endpoint", "double", 6, "rad", "", None, None, None),)
    cause = of_question(news.Asked("flow0", "jtraj", Reason.plain("joint 2 is beyond 2.6"), items, 5))
    assert str(cause.text) == "asks for endpoint (joint 2 is beyond 2.6), and there is no answer that fits"


@pytest.mark.parametrize(
    ("reason", "named"),
    [
        (Reason.of("host.process_killed", name="rt0", signal=9, during=NOTHING), ("", "")),
        (Reason.of("host.process_ended", name="rt0", code=3, during=in_call("flow0/sick")), ("flow0", "sick")),
        (Reason.of("host.call_silent", name="rt0", seconds=2.0, task="flow1/sick"), ("flow1", "sick")),
        (in_call("flow0/sickly"), ("", "")),
    ],
)
def test_a_loss_names_the_task_in_whose_call_it_was(reason, named):  # R-A16, R-X06
    cause = of_loss(reason, [("flow0", "sick"), ("flow1", "sick")])
    assert (cause.kind, cause.subsystem, cause.task) == (CauseKind.LOST, *named)


def test_equal_causes_are_one_to_a_set():
    assert len({of_failure(failed("no")), of_failure(failed("no"))}) == 1
