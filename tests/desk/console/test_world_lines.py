from msgspec import to_builtins

from onika.wire import live
from onika.words.reason import Reason


def test_a_part_of_a_world_is_touched(sit):  # R-K06
    sitting = sit()
    sitting.does("touch boxes panic_left 1", "touch boxes panic_left 0")
    assert sitting.requests_of(live.Touch) == [
        live.Touch("boxes", "panic_left", 1.0),
        live.Touch("boxes", "panic_left", 0.0),
    ]


def test_what_the_runtime_refuses_is_said(sit):
    sitting = sit()
    sitting.runtime.refusals["Touch"] = "no such part"
    assert str(sitting.fails("touch boxes bell 1").reason) == "expected the runtime to do it, found no such part"


def test_values_are_numbers_and_a_value_belongs_to_a_part(sit):
    sitting = sit()
    assert sitting.fails("touch boxes panic_left hard").reason == Reason.of("console.number", word="hard")
    assert sitting.fails("touch boxes panic_left").reason == Reason.of("console.touch_usage", words="boxes panic_left")
    assert sitting.requests_of(live.Touch) == []


def test_the_parts_of_a_world_are_listed(sit):
    sitting = sit()
    sitting.runtime.scenes["boxes"] = {"parts": {"panic_left": to_builtins(Reason.of("workcell.button_takes"))}}
    assert any(
        line.split() == ["panic_left", "1", "pressed,", "0", "let", "go"] for line in sitting.does("touch boxes")
    )
    sitting.runtime.scenes["moon"] = {}
    assert sitting.does("touch moon") == ["it has no parts to touch"]
    assert str(sitting.fails("touch sea").reason) == "expected an open world sea, found no world sea is open"
