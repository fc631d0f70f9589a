import pytest

from onika.wire.world_values import options_of, world_values


def test_what_was_written_is_read_by_world_and_name():  # R-X23
    assert world_values(["boxes.friction=0.5", "boxes.mass=2", "yard.mass=1e-2"]) == {
        "boxes": {"friction": 0.5, "mass": 2.0},
        "yard": {"mass": 0.01},
    }


def test_a_runtime_that_is_started_with_the_options_has_the_same_values():  # R-X23
    values = {"yard": {"mass": 0.1 + 0.2}, "boxes": {"friction": 1e-7, "mass": 3.0}}
    words = options_of(7, values)
    assert words[:2] == ("--shake", "7")
    assert world_values(words[3::2]) == values
    assert options_of(None, {}) == ()


@pytest.mark.parametrize("word", ["boxes", "boxes.mass", "boxes.mass=", "a.b=x", "a b.c=1", "--audit=1", "a.b=-1"])
def test_what_is_none_is_refused(word):  # R-X23
    with pytest.raises(ValueError, match=word.replace(".", "[.]")):
        world_values([word])
