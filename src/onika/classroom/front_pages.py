"""The pages of a class's front: where a learner comes in, and the ground of the board (requirement X25)."""

from html import escape
from string import Template

from onika.web.access.form_page import alert, form_page, words
from onika.words.reason import NOTHING, Reason, in_language

_JOIN = Template("""<form method="post" action="/join?lang=$language">
<h1>$heading</h1>
<p class="about">$about</p>
$wrong
<label for="code">$code</label>
<input id="code" name="code" autocomplete="off" autocapitalize="characters" spellcheck="false" maxlength="16"
 required autofocus>
<label for="name">$name</label>
<input id="name" name="name" autocomplete="nickname" spellcheck="false" maxlength="32" value="$given" required>
<button>$button</button>
</form>""")

_SEAT = Template("""<form>
<h1>$heading</h1>
<p class="about">$about</p>
<a class="button" href="/seat?lang=$language">$button</a>
</form>""")

_BOARD = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Onika</title>
<link rel="stylesheet" href="board/files/board.css">
<script type="module" src="board/files/board.js"></script>
</head>
<body><div id="app"></div></body>
</html>
"""


def join_page(language: str, wrong: Reason = NOTHING, name: str = "") -> str:
    """The page on which somebody says the code of the class and his name; `wrong`: why the last try was in vain."""
    body = _JOIN.substitute(
        language=language,
        heading=words("class.join_heading", language),
        about=words("class.join_about", language),
        code=words("class.join_code", language),
        name=words("class.join_name", language),
        button=words("class.join_button", language),
        given=escape(name[:32], quote=True),
        wrong=alert(wrong, language),
    )
    return form_page(language, "class.join_title", body)


def seat_page(language: str, learner: str, seat: int) -> str:
    """The page of whoever has a seat: the way to it."""
    heading = Reason.of("class.seat_heading", learner=learner, seat=seat)
    body = _SEAT.substitute(
        language=language,
        heading=escape(in_language(heading, language)),
        about=words("class.seat_about", language),
        button=words("class.seat_button", language),
    )
    return form_page(language, "class.join_title", body)


def board_page() -> str:
    """The ground on which the board is drawn."""
    return _BOARD
