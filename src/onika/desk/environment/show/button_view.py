"""How the user's own buttons look to a page (requirement G02)."""

from onika.desk.environment.state.model import Model
from onika.wire.view import ButtonView


def button_views(model: Model) -> dict[str, ButtonView]:
    """The buttons as a page sees them; of two with one name the first."""
    views: dict[str, ButtonView] = {}
    for order, button in enumerate(model.buttons):
        run = model.runs.get(button.name, ButtonView("", 0))
        view = ButtonView(button.command, order, button.spawns_terminal, run.is_running, run.output, run.code)
        views.setdefault(button.name, view)
    return views
