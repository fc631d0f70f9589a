import pytest

from onika.host.diagnosis.stop_cause import CauseKind, of_failure, of_loss, of_question, of_refusal, of_signal
from onika.runtime import news
from onika.runtime.user_input import AskedItem


def failed(text, entry="cycle"):
    return news.Failed("flow0", "puma", entry, text, "puma.py", 7, "trace", 5, values={"TAU_REF": [1.0]})


def test_a_failure_keeps_what_was_said_where_and_with_which_values():  # R-X06
    found = of_failure(failed("ValueError: no"))
    assert (found.kind, found.subsystem, found.task) == (CauseKind.ERROR, "flow0", "puma")
    assert (found.text, found.path, found.line, found.entry) == ("cycle: ValueError: no", "puma.py", 7, "cycle")
    assert found.values == {"TAU_REF": [1.0]}
    assert not found.ends


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("ModuleError: panic button pressed; the drive holds", CauseKind.PRESSED),
        ("ModuleError: the drive has tripped", CauseKind.TRIPPED),
        ("ModuleError: no torque", CauseKind.ERROR),
    ],
)
def test_a_hardware_task_that_fails_over_its_drive_is_told_apart(text, kind):  # R-X06, R-K06
    assert of_failure(failed(text), is_hardware=True).kind is kind


def test_another_task_may_say_what_it_likes():  # R-X06
    assert of_failure(failed("ValueError: tripped over a panic button")).kind is CauseKind.ERROR


@pytest.mark.parametrize("kind", ["ILLEGAL", "SHUTDOWN"])
def test_a_signal_that_ends_the_run_is_a_cause(kind):  # R-A08, R-X06
    found = of_signal(news.Signalled("flow0", "puma", kind, 0, "too hot", 5))
    assert (found.kind.name, found.text, found.task) == (kind, f"{kind}: too hot", "puma")


def test_other_signals_are_no_causes():  # R-X06
    with pytest.raises(ValueError, match="found LEGAL"):
        of_signal(news.Signalled("flow0", "puma", "LEGAL", 0, "", 5))


def test_a_refusal_names_the_command():  # R-X06
    assert of_refusal(news.Refused("flow0", "puma", "on", "it is in ERROR")).text == "on is refused: it is in ERROR"


def test_a_question_names_what_is_asked_for_and_what_was_wrong():  # R-X06, law 25
    items = (AskedItem("endpoint", "double", 6, "rad", "", None, None, None),)
    found = of_question(news.Asked("flow0", "jtraj", "joint 2 is beyond 2.6", items, 5))
    assert found.text == "asks for endpoint (joint 2 is beyond 2.6), and there is no answer that fits"


@pytest.mark.parametrize(
    ("reason", "named"),
    [
        ("processing unit rt0 was killed by signal 9", ("", "")),
        ("processing unit rt0 ended with code 3 in a call of task flow0/sick", ("flow0", "sick")),
        ("rt0 has not answered for 2.0 s: a call of task flow1/sick has not returned", ("flow1", "sick")),
        ("in a call of task flow0/sickly", ("", "")),
    ],
)
def test_a_loss_names_the_task_in_whose_call_it_was(reason, named):  # R-A16, R-X06
    found = of_loss(reason, [("flow0", "sick"), ("flow1", "sick")])
    assert (found.kind, found.subsystem, found.task) == (CauseKind.LOST, *named)


def test_equal_causes_are_one_to_a_set():
    assert len({of_failure(failed("no")), of_failure(failed("no"))}) == 1
