import pytest

from onika.web.access.form_page import alert, form_page, words
from onika.words.reason import NOTHING, Reason


@pytest.mark.parametrize(("language", "title"), [("en", "Onika: a class"), ("es", "Onika: una clase")])
def test_a_page_stands_around_its_body_in_its_language_and_leads_to_the_others(language, title):
    html = form_page(language, "class.join_title", "<form></form>")
    assert f'<html lang="{language}">' in html
    assert f"<title>{title}</title>" in html
    assert "<form></form>" in html
    assert html.count("/?lang=") == 1


def test_what_is_said_is_no_html():
    assert words("class.join_name", "en") == "Your name"
    assert alert(NOTHING, "en") == ""
    assert "&lt;b&gt;" in alert(Reason.plain("<b>"), "en")
