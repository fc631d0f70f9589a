from kit.desk.film_reader import FilmReader
from onika.desk.environment.shared.sharing import MOST_BYTES, shared_file


def player(folder):
    (folder / "player.js").write_text("1")
    (folder / "player.css").write_text("")
    return folder


def test_a_recording_becomes_one_file(watched, tmp_path):  # R-X21
    shared = shared_file(watched.subject, watched.environment.tree, watched.site, player(tmp_path), MOST_BYTES, None)
    assert (shared.fits, shared.is_coarse, shared.notes) == (True, False, ())
    assert len(shared.text) < 100_000
    assert FilmReader.of_page(shared.text).head["format"] == 1


def test_without_a_built_player_there_is_none(watched, tmp_path):  # R-X21: bad input
    wrong = shared_file(watched.subject, watched.environment.tree, watched.site, tmp_path, MOST_BYTES, None)
    assert wrong.key == "desk.page_not_built"


def test_a_file_that_is_spoilt_meanwhile_is_said(watched, tmp_path):  # R-X21: bad input
    watched.subject.path.write_bytes(b"\x89MCAP0\r\n")
    wrong = shared_file(watched.subject, watched.environment.tree, watched.site, player(tmp_path), MOST_BYTES, None)
    assert wrong.key == "desk.recording_unseen"
