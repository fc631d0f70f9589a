"""The front of a class: where learners come in, and the teacher's board (requirement X25).

Whoever knows the code of the class, and says a name that nobody has yet, gets a seat; the board is for whoever has the
key that was printed where the class was begun. Nothing of a seat passes through here but the way to it.
"""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from time import monotonic_ns
from typing import Any

import msgspec
from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from onika.classroom import front_pages
from onika.classroom.board import board
from onika.classroom.room import ClassRoom
from onika.link.address import bracketed, split_host
from onika.web.access.form_page import POLICY
from onika.web.access.wrong_tries import WrongTries
from onika.web.headers import StrictHeaders
from onika.web.login import Login
from onika.web.refused_request import language_of, refused
from onika.web.sent_form import sent_body, sent_form
from onika.wire.class_board import TeacherAct
from onika.words.reason import Reason

_JSON = "application/json"


_ACTS = msgspec.json.Decoder(TeacherAct)


class ClassFront:
    """The front of one class.

    names      under which this machine is called
    static     the board as it was built
    clock      ns that never go back
    """

    def __init__(
        self,
        room: ClassRoom,
        names: Iterable[str],
        port: int,
        static: Path,
        *,
        is_secure: bool = False,
        on_key: Callable[[str], None] = lambda _key: None,
        clock: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._room = room
        self._names = frozenset(name.lower() for name in names)
        self._port = port
        self._static = static
        self._clock = clock
        self._tries = WrongTries()
        self._is_secure = is_secure
        self._scheme = "https" if is_secure else "http"
        prefix = "__Host-" if is_secure else ""
        self._cookie = f"{prefix}onika-class-{port}"
        self._board_cookie = f"{prefix}onika-board-{port}"
        self.login = Login((f"board:{port}",), on_key)
        """The key of the board, which lets one browser in."""

    def application(self) -> Starlette:
        """The application."""
        routes: list[Route | Mount] = [
            Route("/", self._door, methods=["GET"]),
            Route("/join", self._join, methods=["POST"]),
            Route("/seat", self._seat, methods=["GET"]),
            Route("/board", self._board, methods=["GET"]),
            Route("/board/state", self._state, methods=["GET"]),
            Route("/board/act", self._act, methods=["POST"]),
            Route("/board/watch/{seat:int}", self._watch, methods=["GET"]),
        ]
        if self._static.is_dir():
            routes.append(Mount("/board/files", StaticFiles(directory=self._static)))
        handlers = {404: _nothing_there, 405: _other_verb}
        return Starlette(routes=routes, middleware=[Middleware(StrictHeaders)], exception_handlers=handlers)

    # -- learners

    async def _door(self, request: Request) -> Response:
        """The page on which learners come in; for whoever has a seat, the way to it."""
        why = self._stranger(request)
        if why is not None:
            return why
        learner = self._room.learner(request.cookies.get(self._cookie, ""))
        if learner is None:
            return _page(request, front_pages.join_page(language_of(request)))
        return _page(request, front_pages.seat_page(language_of(request), learner.name, learner.seat))

    async def _join(self, request: Request) -> Response:
        why = self._stranger(request, is_form=True)
        if why is not None:
            return why
        form = await sent_form(request, "code", "name")
        if form is None:
            return refused(request, Reason.of("desk.no_form"), 400)
        code, name = form
        token, wrong, status = self._joined(code, name, request.client.host if request.client else "")
        if not token:
            return _page(request, front_pages.join_page(language_of(request), wrong, name), status)
        response = RedirectResponse(f"/?lang={language_of(request)}", 303)
        response.set_cookie(
            self._cookie, token, httponly=True, samesite="strict", secure=self._is_secure, path="/", max_age=30 * 86400
        )
        return response

    def _joined(self, code: str, name: str, address: str) -> tuple[str, Reason, int]:
        wait_ns = self._tries.wait_ns(address, self._clock())
        if wait_ns:
            return "", Reason.of("desk.sign_in_wait", minutes=-(-wait_ns // 60_000_000_000)), 429
        if not self._room.roster.is_code(code):
            self._tries.note(address, self._clock())
            return "", Reason.of("class.wrong_code"), 401
        token, why = self._room.join(name)
        return token, why, 409 if why else 200

    async def _seat(self, request: Request) -> Response:
        """The way to one's own seat."""
        why = self._stranger(request)
        if why is not None:
            return why
        learner = self._room.learner(request.cookies.get(self._cookie, ""))
        if learner is None:
            return RedirectResponse("/", 303)
        return await self._led(request, learner.seat, is_teacher=False)

    async def _led(self, request: Request, number: int, *, is_teacher: bool) -> Response:
        admitted = await self._room.admitted(number, is_teacher=is_teacher)
        if admitted is None:
            return refused(request, Reason.of("class.seat_not_there", seat=number), 503)
        port, key = admitted
        host, _ = split_host(request.headers["host"])
        return RedirectResponse(f"{self._scheme}://{bracketed(host)}:{port}/enter?key={key}", 303)

    # -- the teacher

    async def _board(self, request: Request) -> Response:
        why = self._stranger(request)
        if why is not None:
            return why
        if "key" in request.query_params:
            return self._by_key(request)
        if not self._is_teacher(request):
            return refused(request, Reason.of("class.board_without_key"), 403)
        if not (self._static / "board.js").is_file():
            return refused(request, Reason.of("desk.page_not_built"), 503)
        return HTMLResponse(front_pages.board_page())

    def _by_key(self, request: Request) -> Response:
        response = RedirectResponse("/board", 303)
        if self._is_teacher(request):
            return response
        cookie = self.login.enter(request.query_params["key"])
        if cookie is None:
            return refused(request, Reason.of("class.board_without_key"), 403)
        response.set_cookie(
            self._board_cookie, cookie, httponly=True, samesite="strict", secure=self._is_secure, path="/"
        )
        return response

    async def _state(self, request: Request) -> Response:
        why = self._stranger(request) or self._no_teacher(request)
        if why is not None:
            return why
        address = f"{self._scheme}://{request.headers['host']}/"
        return Response(msgspec.json.encode(board(self._room, address)), 200, media_type=_JSON)

    async def _act(self, request: Request) -> Response:
        why = self._stranger(request, is_form=True) or self._no_teacher(request)
        if why is not None:
            return why
        try:
            wish = _ACTS.decode(await sent_body(request) or b"")
        except ValueError:
            return refused(request, Reason.of("desk.no_form"), 400)
        await self._do(wish)
        return Response(status_code=204)

    async def _do(self, wish: TeacherAct) -> None:
        match wish.act:
            case "freeze" | "release" | "take":
                state: Any = {"freeze": "frozen", "release": "works", "take": "taken"}[wish.act]
                self._room.set_state(wish.seats, state)
            case "tell":
                self._room.tell(wish.seats, wish.text)
            case "collect":
                self._room.collect(wish.seats)
            case "return":
                for seat in wish.seats:
                    self._room.let_return(seat)
            case "restart":
                for seat in wish.seats:
                    await self._room.restart(seat)

    async def _watch(self, request: Request) -> Response:
        why = self._stranger(request) or self._no_teacher(request)
        if why is not None:
            return why
        return await self._led(request, request.path_params["seat"], is_teacher=True)

    # -- who asks

    def _is_teacher(self, request: Request) -> bool:
        given = request.cookies.get(self._board_cookie, "")
        return self.login.visitor({self.login.cookie_name: given}) is not None

    def _no_teacher(self, request: Request) -> Response | None:
        return None if self._is_teacher(request) else refused(request, Reason.of("class.board_without_key"), 403)

    def _stranger(self, request: Request, *, is_form: bool = False) -> Response | None:
        """A refusal for what does not name us, or was sent by a page that is not ours."""
        if not self._is_ours(request.headers):
            return refused(request, Reason.of("desk.no_such_host"), 421)
        if is_form and request.headers.get("origin", "") != f"{self._scheme}://{request.headers.get('host', '')}":
            return refused(request, Reason.of("desk.foreign_page"), 403)
        return None

    def _is_ours(self, headers: Mapping[str, str]) -> bool:
        try:
            host, port = split_host(headers.get("host", ""))
        except ValueError:
            return False
        usual = 443 if self._is_secure else 80
        return host.lower() in self._names and (usual if port is None else port) == self._port


def _page(request: Request, html: str, status: int = 200) -> Response:
    headers = {
        "content-security-policy": POLICY,
        "content-language": language_of(request),
        "referrer-policy": "same-origin",  # with none at all browsers say of a form that it comes from `null`
    }
    return HTMLResponse(html, status, headers)


async def _nothing_there(request: Request, _exception: Exception) -> Response:
    return refused(request, Reason.of("desk.no_such_page"), 404)


async def _other_verb(request: Request, _exception: Exception) -> Response:
    return refused(request, Reason.of("class.no_such_verb"), 405)
