import pytest

from onika.desk.run.transfer_text import sentence, summary
from onika.wire import event
from onika.wire.figures import VariableSteps


def stepped(step, limit=9.76, cycles=0):
    return event.Stepped("flow0", "puma", "TAU_REF", "N m", 1, step, step, limit, cycles, 1.0)


@pytest.mark.parametrize(
    ("stepped", "text"),
    [
        (stepped(3.4385), "3.438 N m at a switch, within 9.76 N m a cycle"),
        (stepped(40.0, cycles=6), "40 N m at a switch, more than 9.76 N m a cycle: blended over 6 cycles"),
        (
            stepped(1e3),
            "1000 N m at a switch, more than 9.76 N m a cycle and too far to blend: refused, the drive holds",
        ),
        (stepped(5.0, limit=0.0), "5 N m at a switch; nobody says how far it may"),
    ],
    ids=["within", "blended", "refused", "unlimited"],
)
def test_a_step_is_one_sentence(stepped, text):  # R-X04
    assert str(sentence(stepped)) == f"puma: TAU_REF[1] stepped by {text}"


def steps(**changes):
    fields = {"step": 40.0, "given": 9.0, "limit": 9.76, "at_s": 4.3, "count": 3, "index": 1} | changes
    return VariableSteps("flow0", "puma", "TAU_REF", **({"unit": "N m"} | fields))


def test_a_summary_tells_only_what_was_too_far():  # R-X04, R-E14
    assert list(summary((steps(step=3.0),))) == []
    lines = summary((steps(blended=2, cycles=6, refused=1), steps(unit="-", blended=1, cycles=4)))
    assert [str(line) for line in lines] == [
        "steps of flow0/TAU_REF: up to 40 N m at 4.30 s, of 9.76 N m a cycle; blended 2 times, over 6 cycles at most, "
        "refused once",
        "steps of flow0/TAU_REF: up to 40 at 4.30 s, of 9.76 a cycle; blended once, over 4 cycles at most",
    ]
