import re

import pytest

from onika.web.access.form_page import POLICY
from onika.web.access.sign_in_page import sign_in_page
from onika.words.reason import Reason


@pytest.mark.parametrize(("language", "words"), [("en", "Password"), ("es", "Contraseña")])
def test_people_are_asked_in_their_language(language, words):  # R-G03, R-F10
    page = sign_in_page(language)
    assert f'<html lang="{language}">' in page
    assert words in page
    assert 'role="alert"' not in page


def test_it_says_why_the_last_try_did_not_let_him_in():
    assert "Try again in 2 minutes." in sign_in_page("en", Reason.of("desk.sign_in_wait", minutes=2))


def test_nothing_that_somebody_wrote_becomes_part_of_it():  # R-F10
    assert "<script" not in sign_in_page("en", Reason.plain("<script>1</script>"))


def test_it_runs_nothing_and_its_form_goes_to_us_alone():  # R-F10
    assert "script" not in POLICY
    assert "form-action 'self'" in POLICY
    assert "<script" not in sign_in_page("en")
    assert re.findall(r'(?:src|href|action)="([^"]*)"', sign_in_page("en")) == ["/sign-in?lang=en", "/?lang=es"]
