"""The page on which people sign in: one form, without scripts, in the language that the browser likes best."""

from string import Template

from onika.web.access.form_page import alert, form_page, words
from onika.words.reason import NOTHING, Reason

_FORM = Template("""<form method="post" action="/sign-in?lang=$language">
<h1>$heading</h1>
<p class="about">$about</p>
$wrong
<label for="name">$name</label>
<input id="name" name="name" autocomplete="username" autocapitalize="none" spellcheck="false" maxlength="32"
 required autofocus>
<label for="password">$password</label>
<input id="password" name="password" type="password" autocomplete="current-password" maxlength="256" required>
<button>$button</button>
</form>""")


def sign_in_page(language: str, wrong: Reason = NOTHING) -> str:
    """The HTML of it; `wrong` says why the last try did not let him in."""
    body = _FORM.substitute(
        language=language,
        heading=words("desk.sign_in_heading", language),
        about=words("desk.sign_in_about", language),
        name=words("desk.sign_in_name", language),
        password=words("desk.sign_in_password", language),
        button=words("desk.sign_in_button", language),
        wrong=alert(wrong, language),
    )
    return form_page(language, "desk.sign_in_title", body)
