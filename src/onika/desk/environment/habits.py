"""What a user wants of the environment that the preference file has no line for (requirements C08, C20, H01).

They are kept as `habits.json` in the state directory; ONIKA_WARNINGS rules over the file.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import msgspec

from onika.files import text, whole
from onika.words.fault import Refusal

NAME = "habits.json"

_NO = ("", "0", "no", "off", "false")


@dataclass(frozen=True, slots=True)
class Habits:
    """Whether warnings are shown, and whether a diary is kept."""

    shows_warnings: bool = True
    keeps_diary: bool = True


def read(state: Path | None, environment: Mapping[str, str]) -> tuple[Habits, str]:
    """The habits of a user, and a sentence where the file cannot be read: then the defaults hold."""
    found, wrong = _kept(state / NAME if state else None)
    warnings = environment.get("ONIKA_WARNINGS")
    return (found if warnings is None else replace(found, shows_warnings=warnings.lower() not in _NO)), wrong


def keep(state: Path | None, habits: Habits) -> Refusal | None:
    """Write them; without a state directory they hold for this session."""
    if state is None:
        return None
    try:
        state.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        return Refusal(f"{state} cannot be made: {error.strerror}")
    done = whole.write(state / NAME, msgspec.json.encode(asdict(habits)).decode() + "\n", whole.ANYTHING)
    return done if isinstance(done, Refusal) else None


def _kept(path: Path | None) -> tuple[Habits, str]:
    if path is None or not path.exists():
        return Habits(), ""
    content, faults = text.load(path, str(path))
    if content is None:
        return Habits(), str(faults[0])
    try:
        return msgspec.json.decode(content, type=Habits), ""
    except msgspec.DecodeError as wrong:
        return Habits(), f"{path}: {wrong}; the defaults hold"
