"""The door of a seat: lets in whom the class sends, and does what the class orders (requirement X25)."""

import asyncio
import shutil
import ssl
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from time import monotonic

from starlette.requests import Request
from starlette.responses import RedirectResponse, Response
from starlette.routing import Route

from onika.classroom import hand_in, messages
from onika.classroom.seat_entrance import TEACHER, SeatEntrance
from onika.classroom.seat_progress import SeatProgress
from onika.classroom.seat_rights import SeatRights
from onika.desk.environment.environment import Environment
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.model import Model
from onika.web.access.entrance import Visitor
from onika.web.hub import Hub
from onika.web.refused_request import refused
from onika.wire import act
from onika.wire.view import ClassSeatView
from onika.words.reason import Reason, reason_of

NEWS_S = 1.0
"""Between two words to the class."""
_PAUSE_S = 3.0
"""Between two hand-ins of one seat."""
_MOST = 5
"""Hand-ins that stay at the seat; the class has its own."""

Channel = tuple[asyncio.StreamReader, asyncio.StreamWriter]


class SeatDoor:
    """The door of one seat, and its tie to the class.

    folder     that of the seat; hand-ins are put together below it
    own        the base directory of its learner
    joins      gives the way to the class
    """

    def __init__(
        self,
        entrance: SeatEntrance,
        rights: SeatRights,
        folder: Path,
        own: Path,
        environment: Environment,
        hub: Hub,
        joins: Callable[[], "asyncio.Future[Channel] | asyncio.Task[Channel]"],
        context: ssl.SSLContext | None = None,
    ) -> None:
        self.entrance = entrance
        self.context = context
        self.ways = (
            Route("/enter", self._enter, methods=["GET"]),
            Route("/hand-in", self._hand_in, methods=["POST"]),
        )
        self._rights = rights
        self._folder = folder
        self._own = own
        self._environment = environment
        self._hub = hub
        self._joins = joins
        self._writer: asyncio.StreamWriter | None = None
        self._pages = 0
        self._progress = SeatProgress(lambda: environment.model, monotonic)
        self._handing = asyncio.Lock()
        self._next_s = 0.0
        self._collecting: asyncio.Task[Reason] | None = None
        hub.limits.append(self._limited)
        environment.observers.append(self._progress.begun)
        environment.followers.append(self._progress.changed)

    def ready(self) -> None:
        """It is open; the class is told as soon as it listens."""

    async def keep(self) -> None:
        """Hear the class, and tell it how its learner gets on; ends when the class says so, or is gone."""
        reader, self._writer = await self._joins()
        self._tell(messages.Opened())
        telling = asyncio.create_task(self._report())
        try:
            while line := await reader.readline():
                order = messages.order(line)
                if isinstance(order, messages.LeaveClass):
                    return
                self._carry_out(order)
        finally:
            telling.cancel()
            if self._collecting is not None:
                await asyncio.wait((self._collecting,))  # what the class was promised is put together to its end

    def close(self) -> None:
        """Let in nobody any more."""
        if self._writer is not None:
            self._writer.close()

    # Inner

    def _carry_out(self, order: messages.SeatOrder) -> None:
        match order:
            case messages.Admit(key=key, is_teacher=is_teacher):
                self.entrance.admit(key, is_teacher=is_teacher)
            case messages.ShutOut():
                self.entrance.shut_out_learner()
                self._hub.end("learner")
            case messages.ShowSeat(seat=seat):
                self._show(seat)
            case messages.Collect():
                if self._collecting is None or self._collecting.done():  # beside: who is let in meanwhile does not wait
                    self._collecting = asyncio.create_task(self._collect())

    async def _collect(self) -> Reason:
        """As the class wishes: a hand-in just before delays it, and is not taken for it."""
        await asyncio.sleep(max(0.0, self._next_s - monotonic()))
        return await self._put_together()

    def _show(self, seat: ClassSeatView) -> None:
        self._rights.state = seat.state
        self._environment.become(lambda model: Done(replace(model, class_seat=seat)))

    async def _report(self) -> None:
        while True:
            sessions = [visitor.session for visitor in self._hub.visitors]
            teachers = sessions.count(TEACHER)
            pages = len(sessions) - teachers
            if pages and not self._pages:
                self._progress.came()
            self._pages = pages
            self._tell(self._progress.standing(pages, teachers))
            await asyncio.sleep(NEWS_S)

    def _tell(self, news: messages.News) -> None:
        if self._writer is not None and not self._writer.is_closing():
            self._writer.write(messages.line(news))

    def _limited(self, visitor: Visitor, command: act.AnyAct) -> Reason:
        why = self._rights.refusal(visitor, command)
        if why and visitor.session != TEACHER:
            self._progress.refused(why)
        return why

    async def _enter(self, request: Request) -> Response:
        """The page for whoever has a key of the class, and the way back for whoever was let in before."""
        if not self.entrance.is_ours(request.headers):
            return refused(request, Reason.of("desk.no_such_host"), 421)
        cookie = self.entrance.enter(request.query_params.get("key", ""))
        if cookie is None:
            if self.entrance.visitor(request.cookies) is not None:
                return RedirectResponse("/", 303)
            return refused(request, self.entrance.closed, 403)
        response = RedirectResponse("/", 303)
        is_secure = self.entrance.is_secure
        response.set_cookie(
            self.entrance.cookie_name, cookie, httponly=True, samesite="strict", secure=is_secure, path="/"
        )
        return response

    async def _hand_in(self, request: Request) -> Response:
        """What the learner's own page asks for."""
        if not self.entrance.is_own_page(request.headers) or self.entrance.visitor(request.cookies) is None:
            return refused(request, self.entrance.closed, 403)
        if self._rights.closed:
            return refused(request, self._rights.closed, 409)
        why = await self._put_together()
        return refused(request, why, 507) if why else Response(status_code=204)

    async def _put_together(self) -> Reason:
        """Hand in what there is now; why not, if so."""
        async with self._handing:
            if monotonic() < self._next_s:
                return Reason.of("class.hand_in_soon", seconds=_PAUSE_S)
            self._next_s = monotonic() + _PAUSE_S
            model: Model = self._environment.model
            texts = hand_in.open_texts(model)
            try:
                folder = await asyncio.to_thread(_new_folder, self._folder / "handed-in")
                why = await asyncio.to_thread(hand_in.put_together, self._own, texts, folder)
            except OSError as wrong:
                why = reason_of(wrong)
                self._tell(messages.HandedIn("", why))
                return why
            self._tell(messages.HandedIn(f"handed-in/{folder.name}", why))
            return why


def _new_folder(all_of_them: Path) -> Path:
    """Behind the last one; it is not made yet. Raises OSError."""
    all_of_them.mkdir(mode=0o700, exist_ok=True)
    numbers = sorted(int(path.name) for path in all_of_them.iterdir() if path.name.isdecimal())
    for old in numbers[: -_MOST + 1]:
        shutil.rmtree(all_of_them / f"{old:04}", ignore_errors=True)
    return all_of_them / f"{max(numbers, default=0) + 1:04}"
