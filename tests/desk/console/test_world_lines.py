from tests.sentences import expected_by, found_by

from onika.wire import live


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
    assert found_by(sitting.fails("touch boxes bell 1")) == "no such part"


def test_values_are_numbers_and_a_value_belongs_to_a_part(sit):
    sitting = sit()
    assert found_by(sitting.fails("touch boxes panic_left hard")) == "'hard'"
    assert "touch boxes panic_left" in found_by(sitting.fails("touch boxes panic_left"))
    assert sitting.requests_of(live.Touch) == []


def test_the_parts_of_a_world_are_listed(sit):
    sitting = sit()
    sitting.runtime.scenes["boxes"] = {"parts": {"panic_left": "1 pressed, 0 let go"}}
    assert any(
        line.split() == ["panic_left", "1", "pressed,", "0", "let", "go"] for line in sitting.does("touch boxes")
    )
    sitting.runtime.scenes["moon"] = {}
    assert sitting.does("touch moon") == ["it has no parts to touch"]
    assert "sea" in expected_by(sitting.fails("touch sea"))
