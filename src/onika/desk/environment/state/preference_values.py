"""The values of the preferences that change something, by their names, whichever file keeps them."""

from dataclasses import asdict
from typing import Any

from onika.desk.environment.state.model import Model

_WITHOUT_EFFECT = {
    *("library", "canvas", "status", "variables", "dictionary", "workspace", "main", "buttons"),
}
"""What a file of §A.5 says of the windows of its time: kept in the file, offered nowhere."""


def preference_values(model: Model) -> dict[str, Any]:
    """The preferences that a user may change, as a page sees them."""
    of_file = {name: value for name, value in asdict(model.preferences).items() if name not in _WITHOUT_EFFECT}
    return of_file | asdict(model.settings)
