from dataclasses import replace

from msgspec import structs

from onika.desk.environment.reconcile.pressed_parts import touched, with_pressed
from onika.desk.environment.state.model import Model
from onika.wire import event


def test_of_each_world_the_parts_are_told_that_are_pressed_now():  # R-K06
    model = with_pressed(with_pressed(Model(), "cell", ("right", "left")), "shed", ("door",))
    assert model.runtime.pressed == {"cell": ("left", "right"), "shed": ("door",)}
    assert with_pressed(model, "cell", ()).runtime.pressed == {"shed": ("door",)}
    assert with_pressed(model, "shed", ("door",)) is model


def test_what_a_hand_elsewhere_has_pressed_is_shown_at_once():  # R-K06
    model = Model()
    model = with_pressed(model, "cell", ("left",))
    model = replace(model, runtime=structs.replace(model.runtime, worlds={"cell": True}))
    pressed = touched(model, event.Touched("cell", "right", 1.0, 2.0))
    assert pressed.runtime.pressed == {"cell": ("left", "right")}
    assert touched(pressed, event.Touched("cell", "left", 0.0, 3.0)).runtime.pressed == {"cell": ("right",)}
    assert touched(model, event.Touched("shed", "door", 1.0, 2.0)) is model  # nobody looks into it here
