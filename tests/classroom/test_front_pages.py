import pytest

from onika.classroom.front_pages import board_page, join_page, seat_page
from onika.words.reason import Reason


@pytest.mark.parametrize("language", ["en", "es"])
def test_the_front_asks_for_code_and_name_and_keeps_the_name(language):  # R-X25
    html = join_page(language, Reason.of("class.wrong_code"), '"><script>')
    assert 'name="code"' in html
    assert 'value="&quot;&gt;&lt;script&gt;"' in html
    assert 'role="alert"' in html
    assert 'role="alert"' not in join_page(language)


def test_whoever_has_a_seat_is_led_to_it():
    html = seat_page("en", "Ana & Ben", 3)
    assert "Ana &amp; Ben, seat 3" in html
    assert 'href="/seat?lang=en"' in html


def test_the_board_runs_nothing_that_stands_in_the_page():
    assert "<script>" not in board_page()
