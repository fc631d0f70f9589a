from dataclasses import replace

from onika.desk.environment.show.button_view import button_views
from onika.desk.environment.state.model import Model
from onika.model.button import Button
from onika.wire.view import ButtonView


def test_of_two_buttons_with_one_name_the_first_is_shown():  # R-G02
    views = button_views(Model(buttons=(Button("tea", "true"), Button("tea", "false"), Button("home", "go", True))))
    assert {name: (button.command, button.order) for name, button in views.items()} == {
        "tea": ("true", 0),
        "home": ("go", 2),
    }


def test_a_button_shows_what_its_command_prints():  # R-G02
    running = ButtonView("", 0, is_running=True, output="water boils")
    model = replace(Model(buttons=(Button("tea", "boil"),)), runs={"tea": running})
    assert button_views(model)["tea"].output == "water boils"
