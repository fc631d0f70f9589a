"""What a user wants of the environment that the preference file has no line for (C08, C20, G05, G08, H01, H04).

They are kept as `habits.json` in the state directory; ONIKA_WARNINGS and ONIKA_LOWER rule over the file,
and ONIKA_PRESENTATION holds for a session.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import msgspec

from onika.files import text, whole
from onika.files.state.state_directory import make_own
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason
from onika.words.unit import UNITS

NAME = "habits.json"

PRESENTATIONS = ("pictures", "both", "words")
"""Pictures, pictures with descriptions, descriptions only: the three groups of §6.2.1."""

_NO = ("", "0", "no", "off", "false")


@dataclass(frozen=True, slots=True)
class Settings:
    """Whether warnings are shown, a diary is kept and the lower level is there to be gone to; and units to read."""

    shows_warnings: bool = True
    keeps_diary: bool = True
    shows_lower: bool = True
    angle_unit: str = "rad"
    """In which angles are read and typed (`words.unit`); files hold radians."""
    length_unit: str = "m"
    """The same of lengths; files hold metres."""
    presentation: str = ""
    """How icons are presented in this session, as a study fixes it (`PRESENTATIONS`); empty: as each browser likes."""


def read(state: Path | None, environment: Mapping[str, str]) -> tuple[Settings, Reason]:
    """The settings of a user, and a sentence where the file cannot be read: then the defaults hold."""
    settings, wrong = _kept(state / NAME if state else None)
    named = {"shows_warnings": "ONIKA_WARNINGS", "shows_lower": "ONIKA_LOWER"}
    overrides: dict[str, Any] = {
        habit: environment[name].lower() not in _NO for habit, name in named.items() if name in environment
    }
    fixed = environment.get("ONIKA_PRESENTATION", "")
    overrides["presentation"] = fixed if fixed in PRESENTATIONS else ""
    return replace(settings, **overrides), wrong


def keep(state: Path | None, values: Mapping[str, Any]) -> Refusal | None:
    """Write these, beside what is kept of the others; without a state directory they hold for this session."""
    if state is None:
        return None
    settings = replace(_kept(state / NAME)[0], **values)
    try:
        make_own(state)
    except OSError as error:
        return Refusal(Reason.of("run.folder_not_made", path=str(state), why=system_reason(error)))
    done = whole.write(state / NAME, msgspec.json.encode(asdict(settings)).decode() + "\n", whole.ANYTHING)
    return done if isinstance(done, Refusal) else None


def _known(settings: Settings) -> Settings:
    """With the units of files in place of those that nobody knows."""
    unknown: dict[str, Any] = {
        name: next(iter(units)) for name, units in UNITS.items() if getattr(settings, name) not in units
    }
    return replace(settings, **unknown)


def _kept(path: Path | None) -> tuple[Settings, Reason]:
    if path is None or not path.exists():
        return Settings(), NOTHING
    content, faults = text.load(path, str(path))
    if content is None:
        return Settings(), faults[0].sentence
    try:
        return _known(msgspec.json.decode(content, type=Settings)), NOTHING
    except msgspec.DecodeError as wrong:
        return Settings(), Reason.of("run.defaults_hold", path=str(path), why=str(wrong))
