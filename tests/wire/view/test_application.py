import msgspec

from onika.wire import view


def test_an_icon_without_marks_is_its_name_and_type():
    assert msgspec.to_builtins(view.StepView(name="jmoveC", type="Joint job")) == {
        "name": "jmoveC",
        "type": "Joint job",
    }
