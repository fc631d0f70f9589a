"""Sessions are readied and ended, and nothing of anybody is lost."""

import fcntl

import pytest

from kit.study.log_text import assembly
from onika.study import folder, kit
from onika.study.preparation import Session, end, planned, prepare
from onika.words.reason import Reason


@pytest.fixture
def study(tmp_path):
    kit.create(tmp_path / "folk")
    (tmp_path / "folk" / "subjects.csv").write_text("subject,group\ns1,words\ns2,both\n")
    return tmp_path / "folk"


def used(session, text=None):
    """What the page leaves in the home of a session."""
    diary = session.home / ".local" / "state" / "onika" / "diary"
    diary.mkdir(parents=True)
    (diary / "2026-01-01T10-00-00-1.log").write_text(text or assembly(4.0))
    (session.home / "programs" / "appl" / "mine.appl").write_text("mine")


def test_a_subject_gets_an_empty_home_and_the_variant_of_the_table(study):  # R-H09
    session = prepare(study, "s1")
    assert isinstance(session, Session)
    assert session.variant == "words"
    assert {path.name for path in session.home.rglob("*")} == {"programs", "appl"}


def test_what_the_subject_before_has_left_stays_where_it_is(study):  # R-H09
    first = prepare(study, "s1")
    used(first)
    second = prepare(study, "s2")
    assert {path.name for path in second.home.rglob("*")} == {"programs", "appl"}
    assert (first.home / "programs" / "appl" / "mine.appl").read_text() == "mine"
    assert prepare(study, "s1").key == "study.session_there"


def test_an_ended_session_is_read_by_the_report_and_nothing_is_removed(study):  # R-H09
    session = prepare(study, "s1")
    used(session)
    (log,) = end(study, "s1")
    assert log.read_text() == assembly(4.0)
    assert len([*session.home.rglob("*.log")]) == 1
    (subject,) = folder.read(study).subjects
    assert (subject.name, subject.group) == ("s1", "words")
    assert end(study, "s1").key == "study.ended_already"
    assert prepare(study, "s1").key == "study.session_there"


def test_what_the_subject_before_has_left_is_put_away_by_the_next_preparation(study):  # R-H09
    used(prepare(study, "s1"))
    session = prepare(study, "s2")
    assert session.put_away == ("s1",)
    assert (study / "logs" / "s1" / "2026-01-01T10-00-00-1.log").read_text() == assembly(4.0)
    assert prepare(study, "s3", "both").put_away == ()


def test_a_session_whose_page_is_open_is_neither_ended_nor_put_away(study):  # R-H09
    session = prepare(study, "s1")
    used(session)
    place = session.home / ".local" / "state" / "onika" / "recovery" / "x"
    place.mkdir(parents=True)
    with (place / ".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        assert end(study, "s1").key == "study.session_open"
        assert prepare(study, "s2").key == "study.session_open"
        assert not (study / "sessions" / "s2").exists()
    assert len(end(study, "s1")) == 1


def test_a_session_in_which_nothing_was_done_is_taken_back(study):  # R-H09
    prepare(study, "s1")
    assert end(study, "s1").key == "study.taken_back"
    assert end(study, "s1").key == "study.no_diary"
    assert isinstance(prepare(study, "s1"), Session)


def test_programs_of_a_session_without_a_diary_stay(study):  # R-H09
    session = prepare(study, "s1")
    (session.home / "programs" / "appl" / "mine.appl").write_text("mine")
    assert end(study, "s1").key == "study.programs_alone"
    assert (session.home / "programs" / "appl" / "mine.appl").read_text() == "mine"
    assert prepare(study, "s1").key == "study.session_there"


def test_what_is_planned_touches_nothing(study):  # R-H09
    used(prepare(study, "s1"))
    assert planned(study, "s2").variant == "both"
    assert not (study / "sessions" / "s2").exists()
    assert not (study / "logs" / "s1").exists()


def test_what_the_browser_of_a_session_kept_goes_with_its_end(study):  # R-H09
    session = prepare(study, "s1")
    used(session)
    profile = session.home / ".local" / "state" / "onika" / "browser"
    profile.mkdir()
    (profile / "History").write_text("s1 was here")
    end(study, "s1")
    assert not profile.exists()
    assert (session.home / "programs" / "appl" / "mine.appl").exists()


def test_an_end_that_was_broken_off_can_be_done_again(study):  # R-H09
    used(prepare(study, "s1"))
    (study / "logs" / ".s1.new").mkdir()
    (study / "logs" / ".s1.new" / "half.log").write_text("half")
    assert len(end(study, "s1")) == 1
    assert [path.name for path in (study / "logs").iterdir()] == ["s1"]


def test_what_cannot_be_is_refused_and_nothing_made(study):  # R-H09
    for name in ("", ".", "..", "../s1", "a/b", "a\nb", ".hidden"):
        assert prepare(study, name, "both").key == "study.no_name"
        assert end(study, name).key == "study.no_name"
    assert prepare(study, "s3").key == "study.no_variant"
    assert prepare(study, "s1", "both").key == "study.other_variant"
    assert end(study, "s1").key == "study.no_diary"
    (study / "s9.log").write_text(assembly(4.0))
    assert isinstance(prepare(study, "s9", "both"), Reason)
    assert not (study / "sessions").exists()
