from onika.wire import live


def test_a_part_of_a_world_is_touched(sit):  # R-K06
    one = sit()
    one.does("touch boxes panic_left 1", "touch boxes panic_left 0")
    assert one.asked(live.Touch) == [
        live.Touch("boxes", "panic_left", 1.0),
        live.Touch("boxes", "panic_left", 0.0),
    ]


def test_what_the_runtime_refuses_is_said(sit):
    one = sit()
    one.runtime.refusals["Touch"] = "no such part"
    assert one.fails("touch boxes bell 1").found == "no such part"


def test_values_are_numbers_and_a_value_belongs_to_a_part(sit):
    one = sit()
    assert one.fails("touch boxes panic_left hard").found == "'hard'"
    assert "touch boxes panic_left" in one.fails("touch boxes panic_left").found
    assert one.asked(live.Touch) == []


def test_the_parts_of_a_world_are_listed(sit):
    one = sit()
    one.runtime.scenes["boxes"] = {"parts": {"panic_left": "1 pressed, 0 let go"}}
    assert any(line.split() == ["panic_left", "1", "pressed,", "0", "let", "go"] for line in one.does("touch boxes"))
    one.runtime.scenes["moon"] = {}
    assert one.does("touch moon") == ["it has no parts to touch"]
    assert "sea" in one.fails("touch sea").expected
