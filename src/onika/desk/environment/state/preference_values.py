"""Every preference by its name, whichever file keeps it."""

from dataclasses import asdict
from typing import Any

from onika.desk.environment.state.model import Model


def preference_values(model: Model) -> dict[str, Any]:
    """Every preference by its name, as a page sees it."""
    return asdict(model.preferences) | asdict(model.habits)
