"""The protocol of a task with an outside program: lines of JSON, one question at a time, one answer to each (F04).

    task     {"onika": 1, "id": 7, "task": "planner", "ask": "path", "from": [0, 1], "to": [1, 1]}
    partner  {"id": 7, "via": [[0.5, 1.2]]}

Sans-I/O: bytes in, bytes out. What a partner says is bounded in length and number; an answer that comes too late, to a
question that was given up, is passed over; what breaks these rules raises ValueError: the connection is to be ended.
"""

from typing import Any

import msgspec

from onika.words.reason import Reason

VERSION = 1
LONGEST = 1 << 16
"""Bytes of one line, in either direction: to read it takes a few tenths of a millisecond."""
UNASKED = 100
"""So many answers to what nobody asks any more are passed over between two that are asked for."""
_SHOWN = 60

_OWN = ("onika", "id", "task", "ask")


class PartnerProtocol:
    """One task's end. `answer` holds the fields of the answer to the last question, once it came."""

    def __init__(self) -> None:
        self.is_open = False
        """A question was asked and neither answered nor given up."""
        self.questions = 0
        """How many were asked."""
        self.late = 0
        """How many answers came to questions that had been given up."""
        self.answer: dict[str, Any] | None = None
        self._rest = bytearray()
        self._unasked = 0

    def ask(self, task: str, what: str, fields: dict[str, Any]) -> bytes:
        """The line that asks this; raises ValueError for fields that are none or that make it too long."""
        own = sorted(set(fields) & set(_OWN))
        if own:
            raise ValueError(Reason.of("runtime.own_fields", names=tuple(_OWN), given=tuple(own)))
        message = {"onika": VERSION, "id": self.questions + 1, "task": task, "ask": what, **fields}
        try:
            line = msgspec.json.encode(message, enc_hook=_plain) + b"\n"
        except TypeError as wrong:
            raise ValueError(Reason.of("runtime.fields_no_json", why=str(wrong))) from None
        if len(line) > LONGEST:
            raise ValueError(Reason.of("runtime.question_too_long", longest=LONGEST, size=len(line)))
        self.questions += 1
        self.is_open, self.answer = True, None
        return line

    def give_up(self) -> None:
        """The question is not open any more; its answer would come too late."""
        self.is_open = False

    def begin(self) -> None:
        """A new connection: nothing was said on it yet."""
        self._rest.clear()
        self._unasked = 0

    def take(self, data: bytes) -> None:
        """What the partner said; raises ValueError with what is wrong with it."""
        self._rest += data
        while (end := self._rest.find(b"\n")) >= 0:
            line = bytes(self._rest[:end])
            del self._rest[: end + 1]
            self._hear(line)
        if len(self._rest) > LONGEST:
            raise ValueError(Reason.of("runtime.line_longer", longest=LONGEST))

    def _hear(self, line: bytes) -> None:
        if len(line) > LONGEST:
            raise ValueError(Reason.of("runtime.line_too_long", longest=LONGEST, size=len(line)))
        try:
            message = msgspec.json.decode(line)
        except (ValueError, RecursionError) as wrong:
            raise ValueError(Reason.of("runtime.answer_no_json", line=_short(line), why=str(wrong))) from None
        number = message.get("id") if isinstance(message, dict) else None
        if type(number) is not int or not 1 <= number <= self.questions:
            raise ValueError(Reason.of("runtime.answer_id", most=self.questions, line=_short(line)))
        if number < self.questions or not self.is_open:
            self._pass_over()
            return
        self.answer, self.is_open, self._unasked = message, False, 0

    def _pass_over(self) -> None:
        self.late += 1
        self._unasked += 1
        if self._unasked > UNASKED:
            raise ValueError(Reason.of("runtime.answers_unasked", count=self._unasked))


def _plain(value: object) -> object:
    """Arrays and NumPy's numbers as plain ones."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"found {type(value).__name__}")


def _short(line: bytes) -> str:
    text = line[: _SHOWN + 1].decode("utf-8", "backslashreplace")
    return text if len(line) <= _SHOWN else text[:_SHOWN] + "…"
