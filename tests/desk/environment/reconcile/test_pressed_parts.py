from onika.desk.environment.reconcile.pressed_parts import with_pressed
from onika.desk.environment.state.model import Model


def test_of_each_world_the_parts_are_told_that_are_pressed_now():  # R-K06
    model = with_pressed(with_pressed(Model(), "cell", ("right", "left")), "shed", ("door",))
    assert model.runtime.pressed == {"cell": ("left", "right"), "shed": ("door",)}
    assert with_pressed(model, "cell", ()).runtime.pressed == {"shed": ("door",)}
    assert with_pressed(model, "shed", ("door",)) is model
