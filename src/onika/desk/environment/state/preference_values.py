"""The values of the preferences by their names, whichever file keeps them."""

from dataclasses import asdict
from typing import Any

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.window_places import WINDOWS, chosen_places

PLACES = "places"
"""Under this name stand the places of all windows together."""


def preference_values(model: Model) -> dict[str, Any]:
    """The preferences that a user may change, as a page sees them."""
    of_file = {name: value for name, value in asdict(model.preferences).items() if name not in WINDOWS}
    return of_file | asdict(model.settings) | {PLACES: chosen_places(model.preferences)}
