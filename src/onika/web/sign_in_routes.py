"""The ways to sign in and out: forms that only a page of ours may send (requirement F10)."""

from collections.abc import Callable

from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import Route

from onika.web.access.form_page import POLICY
from onika.web.access.sign_in import SignIn
from onika.web.access.sign_in_page import sign_in_page
from onika.web.refused_request import language_of, refused
from onika.web.sent_form import sent_form
from onika.words.reason import NOTHING, Reason

_STATUS = {"desk.sign_in_wait": 429, "desk.sign_in_busy": 503}


def sign_in_routes(entrance: SignIn, end: Callable[[str], None]) -> list[Route]:
    """The ways; `end` closes the pages of a session."""

    async def sign_in(request: Request) -> Response:
        if request.method != "POST":
            return RedirectResponse("/", 303)
        why = _foreign(entrance, request)
        if why is not None:
            return why
        form = await sent_form(request, "name", "password")
        if form is None:
            return refused(request, Reason.of("desk.no_form"), 400)
        name, password = form
        token, reason = await entrance.enter(name, password, request.client.host if request.client else "")
        if not token:
            return asked(request, reason, _STATUS.get(reason.key, 401))
        _leave(request)
        response = RedirectResponse("/", 303)
        response.set_cookie(entrance.cookie_name, token, httponly=True, samesite="strict", secure=True, path="/")
        return response

    async def sign_out(request: Request) -> Response:
        why = _foreign(entrance, request)
        if why is not None:
            return why
        _leave(request)
        response = RedirectResponse("/", 303)
        response.delete_cookie(entrance.cookie_name, path="/", secure=True, httponly=True, samesite="strict")
        return response

    def _leave(request: Request) -> None:
        visitor = entrance.visitor(request.cookies)
        if visitor is not None:
            entrance.leave(visitor)
            end(visitor.session)

    return [
        Route("/sign-in", sign_in, methods=["GET", "POST"]),
        Route("/sign-out", sign_out, methods=["POST"]),
    ]


def asked(request: Request, wrong: Reason = NOTHING, status: int = 401) -> Response:
    """The page on which he signs in, in place of what he may not see yet."""
    language = language_of(request)
    headers = {"content-security-policy": POLICY, "content-language": language, "referrer-policy": "same-origin"}
    # with no referrer at all browsers say of a form that it comes from `null`
    return HTMLResponse(sign_in_page(language, wrong), status, headers)


def _foreign(entrance: SignIn, request: Request) -> Response | None:
    """A refusal for what no page of ours has sent."""
    if not entrance.is_ours(request.headers):
        return refused(request, Reason.of("desk.no_such_host"), 421)
    if not entrance.is_own_page(request.headers):
        return refused(request, Reason.of("desk.foreign_page"), 403)
    return None
