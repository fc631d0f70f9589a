"""The partner: a program outside Onika that a task talks to directly, without ever waiting for it (F04, §5.8.3).

A question is sent, and its outcome comes within the partner's patience: an answer, or the reason why there is none.
Nothing here blocks: the descriptor of `fileno` can be read when something has come, be it only the end of patience.
Connections are made when a question needs one, again and again until patience ends. Patience is wall time, in virtual
time too, where the clock stands meanwhile (law 15).
"""

import contextlib
import os
import select
import shlex
import socket
from time import monotonic_ns
from typing import Any

from onika.runtime.alarm import Alarm
from onika.runtime.error import ModuleError
from onika.runtime.partner.address import PartnerAddress
from onika.runtime.partner.answer import PartnerAnswer
from onika.runtime.partner.guarded_child import GuardedChild
from onika.runtime.partner.protocol import PartnerProtocol
from onika.words.reason import NOTHING, Reason, reason_of
from onika.words.system_error import system_reason

_RETRY_NS = 50_000_000
_AT_ONCE = 1 << 16
"""Bytes that are read at once: a partner that floods takes no more of anybody's time than that."""


class Partner:
    """Made by a module in `init`, from its LOCAL lines; `at` is where the partner listens, `starts` what starts it.

    With `starts` alone the program talks over its standard input and output. With both it listens at `at`, which it
    finds in ONIKA_PARTNER. It is started with `init`, again with `on` if it has ended, and ends with the task. Raises
    ModuleError for words that cannot be used. `patience_s` is how long an answer may take.
    """

    def __init__(self, at: str = "", starts: str = "", patience_s: float = 1.0) -> None:
        if not 0.001 <= patience_s <= 3600.0:
            raise ModuleError(Reason.of("runtime.patience_range", seconds=patience_s))
        try:
            self._address = PartnerAddress.parse(at) if at else None
            self._command = shlex.split(starts)
        except ValueError as wrong:
            raise ModuleError(Reason.of("runtime.partner_unfit", why=reason_of(wrong))) from None
        if not (at or self._command):
            raise ModuleError(Reason.of("runtime.partner_nowhere"))
        self.name = at or self._command[0]
        self.task = ""
        self.patience_s = patience_s
        self._protocol = PartnerProtocol()
        self._epoll = select.epoll()
        self._alarm = Alarm()
        self._epoll.register(self._alarm, select.EPOLLIN)
        self._line: socket.socket | None = None
        self._stands = False
        self._started: GuardedChild | None = None
        self._until = 0
        self._out = b""
        self._sent = 0
        self._why: Reason = NOTHING
        self._fault = NOTHING
        self._is_collected = True
        if self._command:
            self._start()

    # What a module may call

    def ask(self, what: str, **fields: Any) -> None:
        """Ask something; arrays go as lists, numbers that are not finite as null. Never waits.

        One question at a time: raises ModuleError where one is open still.
        """
        if self.is_awaited:
            raise ModuleError(self._of_partner(Reason.of("runtime.one_question")))
        self._hear()  # a connection that has ended meanwhile is found now
        try:
            self._out = self._protocol.ask(self.task, what, fields)
        except ValueError as wrong:
            raise ModuleError(self._of_partner(reason_of(wrong))) from None
        self._sent, self._why, self._is_collected = 0, NOTHING, False
        self._until = monotonic_ns() + round(self.patience_s * 1e9)
        self._pursue()

    @property
    def is_awaited(self) -> bool:
        """Whether an answer is owed."""
        return self._protocol.is_open

    def has_answered(self) -> bool:
        """Whether the answer has come since the question; true once. Raises ModuleError where none will come."""
        self.hear()
        if self._fault:
            fault, self._fault = self._fault, NOTHING
            raise ModuleError(fault)
        if self._is_collected or self._protocol.answer is None:
            return False
        self._is_collected = True
        return True

    @property
    def answer(self) -> PartnerAnswer:
        """The answer to the last question; raises ModuleError where there is none."""
        if self._protocol.answer is None:
            raise ModuleError(self._of_partner(Reason.of("runtime.no_answer_yet")))
        return PartnerAnswer(self._protocol.answer)

    def hang_up(self) -> None:
        """Give a question up by ending the connection, from which the partner sees that nobody waits any more."""
        self._give_up()
        self._drop()

    # What the runtime calls

    @property
    def questions(self) -> int:
        """How many were asked."""
        return self._protocol.questions

    @property
    def late(self) -> int:
        """How many answers came too late, and were passed over."""
        return self._protocol.late

    @property
    def is_settled(self) -> bool:
        """Whether there is something that `has_answered` has not told yet."""
        return bool(self._fault) or not (self._is_collected or self._protocol.answer is None)

    def fileno(self) -> int:
        """Can be read when something has come; the same through all connections."""
        return self._epoll.fileno()

    def hear(self) -> None:
        """Take in what has come, and let time pass; whatever it is, it is told by `has_answered`."""
        self._hear()
        if self.is_awaited:
            self._pursue()

    def begin(self) -> None:
        """The task comes on: nothing is asked; a program that has ended is started again."""
        self.rest()
        self._fault, self._is_collected = NOTHING, True
        gone = self._started is not None and (self._started.how_ended or not (self._address or self._line))
        if gone:
            self._drop()
            self._stop()
            self._start()

    def rest(self) -> None:
        """The task is off: the question is given up. The connection stays, and the program that was started."""
        self._hear()
        self._give_up()

    def close(self) -> None:
        """The task ends: so do connection and program. Harmless if it was closed already."""
        if not self._epoll.closed:
            self._drop()
            self._stop()
            self._alarm.close()
            self._epoll.close()

    def __del__(self) -> None:
        if hasattr(self, "_is_collected"):
            self.close()

    # Inner: a question

    def _hear(self) -> None:
        ready = {descriptor for descriptor, _ in self._epoll.poll(0)}
        if self._alarm.fileno() in ready:
            self._alarm.stop()
        if self._line is not None and self._line.fileno() in ready:
            self._converse(self._line)
        if self._started is not None and self._started.fileno() in ready:
            self._look_after(self._started)

    def _pursue(self) -> None:
        """Go on with the open question: call, send, or give up when patience is at its end."""
        left = self._until - monotonic_ns()
        if left <= 0:
            self._fail(self._why or Reason.of("runtime.no_answer_within", seconds=self.patience_s))
            return
        if self._line is None and self._address is not None:
            self._call(self._address)
        elif self._line is None and self._started is not None and self._started.how_ended:
            self._fail(Reason.of("runtime.its_program", how=self._started.how_ended))
        elif self._line is not None and self._stands and self._sent < len(self._out):
            self._send(self._line)
        if self.is_awaited:
            self._alarm.set(left if self._line is not None else min(left, _RETRY_NS))

    def _fail(self, why: Reason) -> None:
        self._give_up()
        self._fault = self._of_partner(why)

    def _of_partner(self, why: Reason) -> Reason:
        return Reason.of("runtime.of_partner", name=self.name, why=why)

    def _give_up(self) -> None:
        self._protocol.give_up()
        self._alarm.stop()
        if 0 < self._sent < len(self._out):
            self._drop()  # half a question would spoil the next one
        self._out, self._sent = b"", 0

    # Inner: the connection

    def _call(self, address: PartnerAddress) -> None:
        try:
            line, self._stands = address.call()
        except OSError as wrong:
            self._why = Reason.of("runtime.nobody_listens", why=system_reason(wrong))
            if self._started is not None and self._started.how_ended:
                self._fail(Reason.of("runtime.its_program", how=self._started.how_ended))
            return
        self._connect(line)
        if self._stands:
            self._send(line)

    def _connect(self, line: socket.socket) -> None:
        self._line = line
        self._protocol.begin()
        self._epoll.register(line, select.EPOLLIN | select.EPOLLOUT)

    def _send(self, line: socket.socket) -> None:
        try:
            while self._sent < len(self._out):
                self._sent += line.send(self._out[self._sent :])
        except BlockingIOError:
            self._epoll.modify(line, select.EPOLLIN | select.EPOLLOUT)
            return
        except OSError as wrong:
            self._lose(Reason.of("runtime.connection_broke", why=system_reason(wrong)))
            return
        self._epoll.modify(line, select.EPOLLIN)

    def _converse(self, line: socket.socket) -> None:
        if not self._stands:
            code = line.getsockopt(socket.SOL_SOCKET, socket.SO_ERROR)
            if code:
                self._why = Reason.of("runtime.nobody_listens", why=system_reason(OSError(code, os.strerror(code))))
                self._drop()
                return
            self._stands = True
        with contextlib.suppress(BlockingIOError):
            try:
                data = line.recv(_AT_ONCE)
            except ConnectionError:
                data = b""
            if not data:
                self._lose(Reason.of("runtime.ended_before_answer"))
                return
            self._take(data)
        if self._line is not None:
            self._send(line)

    def _take(self, data: bytes) -> None:
        was_open = self._protocol.is_open
        try:
            self._protocol.take(data)
        except ValueError as wrong:
            self._drop()
            self._fail(reason_of(wrong))
            return
        answer = self._protocol.answer
        if was_open and answer is not None:
            self._alarm.stop()
            if "error" in answer:
                self._protocol.answer = None
                words = " ".join(str(answer["error"])[:200].split())  # it writes no lines of its own
                self._fail(Reason.of("runtime.it_says", words=words))

    def _lose(self, why: Reason) -> None:
        """The connection is gone: so is a question that was sent on it; one that was not is sent on the next one."""
        was_sent = self._sent > 0
        self._drop()
        if not self.is_awaited:
            return
        self._why = why
        if was_sent and self._address is not None:
            self._fail(why)  # where its program was started for the task alone, its guard says more in a moment

    def _drop(self) -> None:
        if self._line is not None:
            self._epoll.unregister(self._line)
            self._line.close()
        self._line, self._stands, self._sent = None, False, 0

    # Inner: the program

    def _start(self) -> None:
        if self._address is None:
            ours, theirs = socket.socketpair()
            ours.setblocking(False)
            self._started = GuardedChild(self._command, theirs.fileno())
            theirs.close()
            self._stands = True
            self._connect(ours)
        else:
            self._started = GuardedChild(self._command, None, self._address.words)
        self._epoll.register(self._started, select.EPOLLIN)

    def _look_after(self, started: GuardedChild) -> None:
        started.look()
        if started.how_ended:
            self._epoll.unregister(started)
            if self.is_awaited:
                self._fail(Reason.of("runtime.its_program", how=started.how_ended))

    def _stop(self) -> None:
        if self._started is not None:
            if not self._started.how_ended:
                self._epoll.unregister(self._started)
            self._started.close()
        self._started = None
