import pytest
from starlette.requests import Request

from onika.link import refusal_header
from onika.web.refused_request import language_of, refused
from onika.words.reason import Reason


def request(query="", languages="es"):
    headers = [(b"accept-language", languages.encode())]
    return Request({"type": "http", "method": "GET", "path": "/", "query_string": query.encode(), "headers": headers})


def test_a_refusal_says_why_in_the_language_of_the_browser_and_to_programs():  # R-G03
    reason = Reason.of("desk.no_such_page")
    answer = refused(request(), reason, 404)
    assert answer.status_code == 404
    assert answer.headers["content-language"] == "es"
    assert refusal_header.read(answer.headers[refusal_header.HEADER]) == reason
    assert answer.body.decode().startswith("no hay nada")


@pytest.mark.parametrize(
    ("query", "languages", "language"),
    [("", "es", "es"), ("", "fr", "en"), ("lang=en", "es", "en"), ("lang=xx", "es", "es"), ("lang=<b>", "", "en")],
)
def test_the_language_may_be_named(query, languages, language):  # R-G03
    assert language_of(request(query, languages)) == language
