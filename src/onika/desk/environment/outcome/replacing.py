"""What a save replaces is kept, so that it can be brought back (requirement X10)."""

from pathlib import Path

from onika.desk.environment.outcome.services import Services
from onika.files import text
from onika.store.replaced_texts import ReplacedTexts
from onika.wire import page


def present_text(path: Path) -> str:
    """What a file holds before it is saved over; empty: nothing that could be brought back."""
    return (text.load(path, str(path))[0] or "") if path.is_file() else ""


def kept(path: Path, former: str, outside: Services) -> tuple[page.Say, ...]:
    """Keep what was replaced; a line where it could not be kept: the save stands all the same."""
    if not former or outside.state is None or present_text(path) == former:
        return ()
    refused = ReplacedTexts(outside.state).keep(path, former, outside.calendar())
    return () if refused is None else (page.Say("warning", refused.reason),)
