"""The answer to a request that is refused: the sentence for people, its key for programs."""

from starlette.requests import HTTPConnection, Request
from starlette.responses import PlainTextResponse, Response

from onika.link import refusal_header
from onika.words.accepted_language import accepted_language
from onika.words.reason import Reason, in_language
from onika.words.sentence import LANGUAGES


def refused(request: Request, reason: Reason, code: int) -> Response:
    """The sentence in the language of ours that the browser likes best, and the reason in a header for programs."""
    language = language_of(request)
    headers = {"content-language": language, refusal_header.HEADER: refusal_header.written(reason)}
    return PlainTextResponse(f"{in_language(reason, language)}\n", code, headers)


def language_of(request: HTTPConnection) -> str:
    """The language that the address names, else the one that the browser likes best."""
    named = request.query_params.get("lang", "")
    return named if named in LANGUAGES else accepted_language(",".join(request.headers.getlist("accept-language")))
