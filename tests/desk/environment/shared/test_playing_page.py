import re

import pytest

from kit.desk.film_reader import FilmReader
from onika.desk.environment.shared.playing_page import Player, playing_page, room_for_document

PLAYER = Player("let a = '</script><!--'", "a::after { content: '</style>' }")


def test_nothing_ends_the_script_or_the_styles_early():  # R-X21: bad input
    page = playing_page("run", b"abc", PLAYER)
    assert page.count("</script>") == 2
    assert page.count("</style>") == 1
    assert "<\\!--" in page


def test_the_name_of_a_run_is_text_and_nothing_else():  # R-X21: bad input
    page = playing_page("<script>alert(1)</script>", b"", PLAYER)
    assert "<script>alert" not in page


def test_the_file_may_not_connect_to_anything():  # R-X21: without network
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', playing_page("run", b"", PLAYER))[1]
    assert policy.startswith("default-src 'none'")
    assert "http" not in policy and "*" not in policy and "connect-src" not in policy
    assert not re.search(r'(?:src|href)="(?!data:)', playing_page("run", b"", PLAYER))


def test_the_run_stands_in_the_page_and_comes_back():
    with pytest.raises(AssertionError):
        FilmReader.of_page("<p>none</p>")
    assert 'id="run">YWJj<' in playing_page("run", b"abc", PLAYER)


def test_the_document_gets_what_the_player_leaves():  # R-X21: at most 5 MB
    room = room_for_document(PLAYER, 1_000_000)
    assert len(playing_page("run", bytes(room), PLAYER)) <= 1_000_000
    assert room > 700_000
    assert room_for_document(PLAYER, 10) == 0


def test_a_player_that_was_not_built_is_a_matter_of_the_system(tmp_path):
    with pytest.raises(OSError):
        Player.read(tmp_path)
    (tmp_path / "player.js").write_text("1")
    (tmp_path / "player.css").write_text("é")
    assert Player.read(tmp_path) == Player("1", "é")
    assert Player.read(tmp_path).bytes == 3
