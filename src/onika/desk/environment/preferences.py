"""Preferences are changed while one works, and kept at once (requirements G01, B12)."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from typing import Any

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state import settings
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.preference_values import PLACES, preference_values
from onika.desk.environment.state.restoration import own_step
from onika.desk.environment.state.settings import Settings
from onika.desk.environment.state.window_places import places_of
from onika.model.preferences import STATUS_COLUMNS
from onika.wire import act, page
from onika.words.fault import Refusal
from onika.words.reason import Reason, reason_of
from onika.words.unit import UNITS

_LONGEST = 10_000
"""Pixels or characters: what is longer is found on no screen."""

_SETTINGS = {field.name for field in fields(Settings)}


class _Wrong(ValueError):
    """A value that a preference cannot have; its reason says what was expected."""


def prefer(model: Model, command: act.Prefer, outside: Services) -> Done | No:
    """Change preferences, all that are named or none; each that cannot be so is in `fields`.

    That a window was moved is no step to take back: it is moved back by hand.
    """
    now = preference_values(model)
    taken: dict[str, Any] = {}
    wrong: dict[str, Reason] = {}
    for name, value in command.values.items():
        try:
            taken[name] = _taken(name, value, now)
        except ValueError as why:
            wrong[name] = reason_of(why)
    if wrong:
        reasons = tuple(Reason.of("run.what_why", what=name, why=why) for name, why in wrong.items())
        return No(Reason.of("run.together", parts=reasons), fields=wrong)
    places = taken.pop(PLACES, {})
    of_file = {name: value for name, value in taken.items() if name not in _SETTINGS} | places
    of_settings = {name: value for name, value in taken.items() if name in _SETTINGS}
    preferred = replace(model.preferences, **of_file)
    changed = replace(
        model,
        preferences=preferred,
        settings=replace(model.settings, **of_settings),
        libraries=model.libraries if not of_file else replace(model.libraries, preferences=preferred),
    )
    before = {name: now[name] for name in taken}
    step = own_step(Reason.of("run.changing_preferences"), act.Prefer(before), act.Prefer(taken))
    own = step if before != taken else None
    return Done(changed, says=tuple(_kept(of_file, of_settings, outside)), own=own)


def leave(model: Model, outside: Services) -> Refusal | None:
    """At the end of a session: write the preferences where there is no file of them yet; why not, if so (B12)."""
    return outside.site.keep_preferences(model.preferences)


def _kept(of_file: Mapping[str, Any], of_settings: Mapping[str, Any], outside: Services) -> Iterator[page.Say]:
    """Write what was asked for; a no is told, and the change holds for this session."""
    refused = [_filed(of_file, outside)] if of_file else []
    if of_settings:
        refused.append(settings.keep(outside.state, of_settings))
    for refusal in refused:
        if refusal is not None:
            yield page.Say("warning", Reason.of("run.holds_for_session", reason=refusal.reason))


def _filed(values: Mapping[str, Any], outside: Services) -> Refusal | None:
    """The values into the user's file as it is now, where there is one."""
    opened, faults = outside.site.open_preferences()
    wrong = [fault for fault in faults if not fault.is_note]
    if wrong:  # to write it again would lose what is wrong in it, which may be a word away from right
        return Refusal(Reason.of("run.preferences_left", faults=tuple(fault.sentence for fault in wrong)))
    if opened is None:
        return None
    done = outside.site.save_preferences(replace(opened.value, **values), opened)
    return done if isinstance(done, Refusal) else None


def _taken(name: str, value: Any, now: Mapping[str, Any]) -> Any:
    """A value as the preference of that name has it; raises _Wrong."""
    if name not in now or name == "presentation":  # a study fixes it, and no act changes it
        raise _Wrong(Reason.of("run.no_preference"))
    if name == PLACES:
        return places_of(value)
    before = now[name]
    if isinstance(before, bool):
        return _flag(value)
    if isinstance(before, int):
        return _length(value)
    if name in UNITS:
        return _unit(name, value)
    return _columns(value)


def _flag(value: Any) -> bool:
    if not isinstance(value, bool):
        raise _Wrong(Reason.of("run.yes_or_no"))
    return value


def _length(value: Any) -> int:
    is_whole = isinstance(value, int) or (isinstance(value, float) and value.is_integer())
    if isinstance(value, bool) or not is_whole:
        raise _Wrong(Reason.of("run.whole_number"))
    if not 1 <= value <= _LONGEST:
        raise _Wrong(Reason.of("run.number_range", most=_LONGEST, given=int(value)))
    return int(value)


def _unit(name: str, value: Any) -> str:
    if not isinstance(value, str) or value not in UNITS[name]:
        raise _Wrong(Reason.of("run.one_of", words=tuple(UNITS[name])))
    return value


def _columns(value: Any) -> tuple[str, ...]:
    if not isinstance(value, list | tuple) or len({*map(str, value)}) != len(value):
        raise _Wrong(Reason.of("run.columns_once"))
    unknown = [str(name) for name in value if name not in STATUS_COLUMNS]
    if unknown:
        columns = " ".join(STATUS_COLUMNS)
        raise _Wrong(Reason.of("run.columns_unknown", columns=columns, unknown=" ".join(unknown)))
    return tuple(value)
