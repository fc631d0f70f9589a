from kit.desk.film_reader import FilmReader
from onika.desk.environment.shared.recorded_document import PERIODS_S, recorded_document

LARGE = 10**9


def test_every_instant_of_the_document_is_what_a_page_is_shown(watched):  # R-X21: instants equal the recording
    film = FilmReader(recorded_document(watched.subject, watched.environment.tree, LARGE).content)
    assert film.at_s[0] == 0.0
    for place in range(0, len(film.at_s), 7):
        values = watched.glance(film.at_s[place]).values
        assert film.value("flow0/A", place) == [values["flow0/A"]]
        assert film.value("flow0/WORD", place) == values["flow0/WORD"]


def test_a_document_that_would_be_too_large_has_fewer_instants(watched):  # R-X21: at most 5 MB
    fine = recorded_document(watched.subject, watched.environment.tree, LARGE)
    coarse = recorded_document(watched.subject, watched.environment.tree, len(fine.content) - 300)
    assert (fine.period_s, fine.fits) == (PERIODS_S[0], True)
    assert coarse.fits and coarse.period_s > fine.period_s and coarse.instants < fine.instants
    assert {1.0, 2.0} < set(FilmReader(coarse.content).at_s)  # where actions begin
    tiny = recorded_document(watched.subject, watched.environment.tree, 10)
    assert not tiny.fits


def test_a_cut_recording_is_held_up_to_where_it_was_cut(cinema):  # R-X21: bad input
    cinema.look(cinema.film(cinema.open([]), ends=False))
    subject = cinema.environment.model.review_session.subject
    film = FilmReader(recorded_document(subject, cinema.environment.tree, LARGE).content)
    recording = film.head["tree"]["review"]["recording"]
    assert recording["is_whole"] is False
    assert film.at_s[-1] == recording.get("end_s", 0.0)
