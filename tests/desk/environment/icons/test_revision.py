from pathlib import Path

import pytest

from kit.desk.dictionary_fixture import WHITE, DictionaryFixture, plain
from kit.labs.laboratory import Laboratory, target
from onika.wire import act


@pytest.fixture
def cabinet(tmp_path):
    Laboratory(tmp_path / "lab").application("naps", [target("rest", "Pause object", "1.0")])
    return DictionaryFixture(tmp_path, plain("grip"), plain("rest", "Pause object", "a while", (1.0,)))


def test_a_target_is_changed_in_its_file_and_the_page_has_it_at_once(cabinet):  # R-D08, R-D05
    path = cabinet.base.onikon_file("rest")
    path.write_text("# by hand\n" + path.read_text())
    cabinet.look()
    cabinet.do(act.EditOnikon("rest", "for  long", (("9",),), WHITE))
    assert (cabinet.icon("rest").description, cabinet.icon("rest").values) == ("for long", (("9",),))
    assert path.read_text().startswith("# by hand\n")
    cabinet.do(act.EditOnikon("rest", "for very long"))
    assert cabinet.icon("rest").values == (("9",),)
    assert cabinet.look() == 0


def test_what_is_wrong_with_it_is_told_at_once_and_an_action_has_no_values(cabinet):  # R-D08
    no = cabinet.no(act.EditOnikon("rest", values=(("-1",),), picture="x"))
    assert str(no.fields["duration"]) == "-1 is below 0 s" and "picture" in no.fields
    assert "expected no values" in str(cabinet.no(act.EditOnikon("grip", values=(("1",),))).fields["values"])
    assert "no open dictionary" in str(cabinet.no(act.EditOnikon("none")).reason)


def test_a_file_that_somebody_else_changed_is_overwritten_only_where_that_is_meant(cabinet):  # R-B07
    cabinet.base.save_onikon(plain("rest", "Pause object", "theirs", (2.0,)), overwrites=True)
    no = cabinet.no(act.EditOnikon("rest", "ours"))
    cabinet.do(no.remedies[0].act)
    assert cabinet.icon("rest").description == "ours"


def test_a_shipped_icon_that_is_changed_is_a_copy(cabinet):  # R-B07, R-D15
    shipped = cabinet.icon("jmoveC")
    before = Path(shipped.path).read_bytes()
    assert shipped.words == {"es": "mueve las articulaciones"}
    cabinet.do(act.EditOnikon("jmoveC", "go", overwrites=True))
    assert Path(shipped.path).read_bytes() == before and "over that of puma" in str(cabinet.says[-1].text)
    copy = cabinet.icon("jmoveC")
    assert (copy.description, copy.dictionary, copy.words) == ("go", str(cabinet.own.path), {})
    assert "other languages" in str(cabinet.says[-1].text)
    assert (copy.source, str(copy.trouble)) == (shipped.source, "")
    cabinet.do(act.RemoveOnikon("jmoveC", confirmed=True))  # then the shipped one is there again
    assert cabinet.icon("jmoveC") == shipped


def test_what_it_says_in_other_languages_stays_as_long_as_it_says_the_same(cabinet):  # R-X11
    cabinet.do(act.EditOnikon("home", picture=WHITE, base=str(cabinet.own.path)))
    assert cabinet.icon("home").words["es"]


def test_an_icon_is_deleted_only_where_that_is_meant_and_who_has_it_is_told(cabinet):  # R-D05
    no = cabinet.no(act.RemoveOnikon("rest"))
    assert "*Bring back*" in str(no.reason) and "in naps" in str(no.reason)
    cabinet.do(no.remedies[0].act)
    assert cabinet.names == ["grip"] and not cabinet.base.onikon_file("rest").exists()
    assert "in naps" not in str(cabinet.no(act.RemoveOnikon("grip")).reason)
    assert "comes with Onika" in str(cabinet.no(act.RemoveOnikon("noop", confirmed=True)).reason)


def test_one_that_cannot_be_deleted_stays(cabinet, monkeypatch):  # R-B07

    def refuse(*_args, **_more):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "unlink", refuse)
    assert "cannot be deleted" in str(cabinet.no(act.RemoveOnikon("rest", confirmed=True)).reason)
