import stat

import msgspec
import pytest

from onika.classroom.roster import Grade, GradedExpectation, Roster, RosterFile, tidied
from onika.words.reason import Reason


def joined(roster, *names):
    for name in names:
        roster = roster.joined(name, f"token of {name}")
        assert isinstance(roster, Roster), roster
    return roster


def test_each_learner_gets_the_next_seat(tmp_path):  # R-X25
    roster = joined(Roster("ABCDEF", 3), "Ana", "Ben")
    assert [(learner.name, learner.seat) for learner in roster.learners] == [("Ana", 1), ("Ben", 2)]
    assert roster.of_token("token of Ben").seat == 2
    assert roster.of_token("") is None


def test_nobody_takes_the_name_or_the_seat_of_another(tmp_path):  # R-X25
    roster = joined(Roster("ABCDEF", 2), "Ana", "Ben")
    assert roster.joined("ana", "x").key == "class.name_taken"
    assert roster.joined("Eve", "x").key == "class.full"


def test_whoever_is_let_in_again_keeps_his_seat_and_the_token_of_before_is_void():
    roster = joined(Roster("ABCDEF", 2), "Ana", "Ben")
    roster = roster.with_learner(msgspec.structs.replace(roster.at(1), may_return=True))
    again = roster.joined("ANA", "new")
    assert again.of_token("new").seat == 1
    assert again.of_token("token of Ana") is None
    assert again.joined("Ana", "another").key == "class.name_taken"


def test_the_code_is_of_letters_that_nobody_mistakes_and_small_ones_are_as_good():
    roster = Roster.new(1)
    assert len(roster.code) == 6
    assert not set(roster.code) & set("IO01")
    assert roster.is_code(f" {roster.code.lower()} ")
    assert not roster.is_code(roster.code[:-1])
    assert not roster.is_code("ñ")


@pytest.mark.parametrize(
    ("name", "kept"),
    [
        (" Ana  María ", "Ana María"),
        ("a/../b", "a..b"),
        ("<i>", "i"),
        ("", ""),
        ("..", ""),
        ("x" * 33, ""),
        ("\x1b[1m", "1m"),
    ],
)
def test_a_name_is_of_letters_and_leads_nowhere(name, kept):
    assert tidied(name) == kept


def test_what_is_known_of_a_class_outlasts_it_for_its_owner_only(tmp_path):  # R-X25
    file = RosterFile(tmp_path / "class")
    roster = joined(file.read(5), "Ana")
    grade = Grade(1, (GradedExpectation("LAMP == 1", holds=False, why=Reason.of("class.nothing_to_run")),))
    roster = roster.with_learner(msgspec.structs.replace(roster.at(1), state="frozen", handed_in=1, grade=grade))
    assert not file.write(roster)
    assert RosterFile(tmp_path / "class").read(5) == roster
    assert stat.S_IMODE((tmp_path / "class" / "class.json").stat().st_mode) == 0o600
    assert roster.at(1).view.grade == (0, 1)


def test_a_class_has_as_many_seats_as_it_needs_for_those_who_are_in_it(tmp_path):
    file = RosterFile(tmp_path)
    file.write(joined(file.read(3), "Ana", "Ben"))
    assert RosterFile(tmp_path).read(1).seats == 2


def test_a_file_that_is_none_is_told(tmp_path):
    (tmp_path / "class.json").write_text("{")
    with pytest.raises(ValueError):
        RosterFile(tmp_path).read(3)
