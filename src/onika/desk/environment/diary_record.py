"""What a line of the diary has beside its columns: all that a session is rebuilt from (requirement H08, decision 70).

An act stands there whole, what a runtime has told, what others have written into files. Nobody is named: a secret is
never written, who acts is a number, sessions of others are `session 1`, a home is `~`, and a base directory is its
number in the search path, so that a log can be replayed on a copy that stands elsewhere.
"""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast

import msgspec

from onika.desk.environment.environment import ActAnswer
from onika.store.shipped import shipped
from onika.wire import act, event, request
from onika.wire.booking import BookingList
from onika.words.homeless import homeless

LARGEST = 256 * 1024
"""Bytes of a record; what is larger is told by its kind and its length."""

LABS = "{labs}"
"""Stands for the folder of the shipped laboratories."""

_SECRET = frozenset(("token", "secret", "user"))
_USER_IN_ADDRESS = re.compile(r"(?<=://)[^/@\s\"]+@")
_UNHEARD = frozenset(
    ("Push", "Sample", "Scene", "Sessions", "Book", "ExtendBooking", "CancelBooking", "Bookings", "Listen")
)
"""Requests whose answers no document depends on: what a page looks at, who is there, for whom a robot is booked."""
_OF_OTHERS = (event.Company, event.SlotEnds, BookingList)
_HOLDERS = frozenset(("holder", "to"))


def place_names(directories: Sequence[Path]) -> Mapping[str, str]:
    """What stands for the folders of a search path: `{labs}` for the shipped ones, `{base0}` … for each other."""
    labs = shipped()
    others = [path for path in directories if not path.is_relative_to(labs)]
    named = {str(path): f"{{base{number}}}" for number, path in enumerate(others)}
    return {**named, str(labs): LABS}


class DiaryRecord:
    """Makes records.

    session     the name of the session, of no meaning
    places      what stands for folders, by their paths
    home        that of the user
    """

    def __init__(self, session: str, places: Mapping[str, str], home: str) -> None:
        self._session = session
        self._home = home
        self._places = [
            (re.compile(rf'{re.escape(_inner(path))}(?=[/"\\\s:]|$)'), name)
            for path, name in sorted(places.items(), key=lambda pair: -len(pair[0]))
        ]
        self._people: dict[str, int] = {}
        self._sessions: dict[str, str] = {}

    def text(self, place: int, content: Mapping[str, Any]) -> str:
        """The record of a line, as JSON on one line."""
        head = {"s": self._session, "n": place}
        body = _encoded({**head, **content})
        if len(body) > LARGEST:
            body = _encoded({**head, "left_out": next(iter(content), ""), "bytes": len(body)})
        return self.nameless(body)

    def nameless(self, text: str) -> str:
        """A text without the folders of a home, and with the names of those that have one."""
        for path, name in self._places:
            text = path.sub(name.replace("\\", r"\\"), text)
        return _USER_IN_ADDRESS.sub("", homeless(text, self._home))

    def of_act(self, command: act.AnyAct, by: str, answer: ActAnswer) -> Mapping[str, Any]:
        """An act, who did it, and what it was answered, as far as that is short."""
        fields = {name: value for name, value in msgspec.to_builtins(command).items() if name not in _SECRET}
        if isinstance(command, act.Hand):
            fields = self._without_names(fields)
        record: dict[str, Any] = {"act": fields, "by": self._people.setdefault(by, len(self._people))}
        if answer.no is not None:
            record["no"] = answer.no.reason.key
        elif isinstance(answer.value, str | int) and len(str(answer.value)) < 100:
            record["value"] = answer.value
        return record

    def of_message(self, station: str, request: str, message: msgspec.Struct) -> Mapping[str, Any] | None:
        """What a runtime has told; None: nothing that a session is rebuilt from, or it names others."""
        if request in _UNHEARD or isinstance(message, _OF_OTHERS):
            return None
        content = self._without_names(msgspec.to_builtins(message))
        record: dict[str, Any] = {"reply": content, "to": request} if request else {"event": content}
        if station:
            record["station"] = station
        return record

    def _without_names(self, value: Any, key: str = "") -> Any:
        """Builtins with `session 1` in place of each holder."""
        if isinstance(value, dict):
            return {name: self._without_names(part, name) for name, part in value.items()}
        if isinstance(value, list | tuple):
            return [self._without_names(part, key) for part in value]
        if isinstance(value, str) and value and key in _HOLDERS:
            self._sessions.setdefault(value, f"session {len(self._sessions) + 1}")
        return self._sessions.get(value, value) if isinstance(value, str) else value


def reply_of(content: Any) -> request.Response:
    """What a runtime has replied, as a record has it; raises msgspec.ValidationError."""
    return cast(request.Response, msgspec.convert(content, request.Response, str_keys=True))


def event_of(content: Any) -> event.Event:
    """What a runtime has told, as a record has it; raises msgspec.ValidationError."""
    return cast(event.Event, msgspec.convert(content, event.Event, str_keys=True))


def _encoded(content: Mapping[str, Any]) -> str:
    return msgspec.json.encode(content).decode()


def _inner(text: str) -> str:
    """A text as it stands within JSON."""
    return msgspec.json.encode(text).decode()[1:-1]
