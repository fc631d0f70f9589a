from dataclasses import replace

from kit.desk.film_reader import FilmReader
from onika.wire import act


def with_player(cinema, folder):
    (folder / "player.js").write_text("1")
    (folder / "player.css").write_text("")
    environment = cinema.environment
    environment._surroundings = replace(environment._surroundings, player=folder)
    return cinema


def test_the_recording_that_is_looked_at_is_handed_over_as_a_file(watched, tmp_path):  # R-X21: Share… in the page
    answer = with_player(watched, tmp_path).later(act.ShareRecording())
    assert answer.value.name == "film.html"
    assert answer.value.every_s == 0.0
    assert FilmReader.of_page(answer.value.text).head["tree"]["review"]["recording"]["path"] == "film.mcap"


def test_without_a_recording_there_is_nothing_to_share(cinema, tmp_path):  # R-X21: bad input
    assert "no recording is looked at" in str(with_player(cinema, tmp_path).no(act.ShareRecording()).reason)


def test_where_nothing_can_be_shared_it_is_refused(watched):  # R-X21: bad input
    assert watched.no(act.ShareRecording()).reason.key == "run.no_recordings_here"
