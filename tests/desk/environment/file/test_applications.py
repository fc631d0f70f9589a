import shutil
from pathlib import Path

import pytest

from kit.desk.app_fixture import AppFixture
from kit.desk.environment_fixture import EnvironmentFixture
from onika.desk.environment.initial_model import opened
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.wire import act
from onika.wire.view import ShowSaveAs

SHIPPED = sorted((shipped() / "boxes" / "appl").glob("*.appl"))


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def saved(gallery, *icons, name="job1"):
    doc = gallery.begun(*icons)
    gallery.do(act.Save(doc, name, str(gallery.base.path)))
    return doc, gallery.base.application_file(name)


def test_a_new_application_has_a_name_that_nobody_else_has(gallery):  # R-D04
    first = gallery.do(act.New())
    doc = gallery.do(act.NewApplication(3, True))
    names = [gallery.environment.tree.documents[first].name, gallery.view(doc).name]
    assert names == ["Untitled-1", "Untitled-2"]
    view = gallery.view(doc)
    assert (list(view.flows), view.is_parallel, view.is_dirty) == (["0", "1", "2"], True, False)
    assert gallery.view(gallery.do(act.NewApplication())).name == "Untitled-3"
    assert "flows" in gallery.no(act.NewApplication(0)).fields
    assert "flows" in gallery.no(act.NewApplication(33)).fields


def test_it_is_saved_under_a_name_and_opened_by_it_or_by_its_file(gallery):  # R-D04
    doc, path = saved(gallery, "move", "there")
    assert (gallery.view(doc).name, gallery.view(doc).path, gallery.view(doc).is_dirty) == ("job1", str(path), False)
    assert gallery.do(act.Open(str(path))) == doc
    gallery.do(act.Close(doc))
    again = gallery.do(act.Open("job1"))
    assert gallery.flow(again) == "move there"
    assert again != doc
    assert gallery.do(act.Open(str(path))) == again


def test_a_configuration_of_that_name_is_found_first(gallery):
    saved(gallery, "grip")
    conf = gallery.do(act.New())
    gallery.do(act.Save(conf, "job1", str(gallery.base.path)))
    gallery.do(act.Close(conf))
    assert gallery.do(act.Open("job1")).startswith("c")


@pytest.mark.parametrize("path", ["nobody", "/no/such.appl", "/etc/passwd.appl"])
def test_what_is_not_there_is_not_opened(gallery, path):
    assert gallery.no(act.Open(path)).reason


def test_a_file_in_no_base_directory_is_not_opened(gallery, tmp_path):
    _, path = saved(gallery, "grip")
    stray = tmp_path / "stray.appl"
    shutil.copy(path, stray)
    assert "no folder appl/" in str(gallery.no(act.Open(str(stray))).reason)


def test_without_a_name_or_a_base_it_is_asked_for(gallery):
    doc = gallery.begun("grip")
    no = gallery.no(act.Save(doc))
    assert no.remedies[0].show == ShowSaveAs()
    assert gallery.no(act.Save(doc, "no name")).fields
    assert Path(gallery.do(act.Save(doc, "mine"))) == gallery.site.own / "appl" / "mine.appl"


def test_a_file_of_that_name_is_overwritten_only_if_meant(gallery):  # R-X01
    saved(gallery, "grip")
    doc = gallery.begun("open")
    no = gallery.no(act.Save(doc, "job1", str(gallery.base.path)))
    gallery.do(no.remedies[0].act)
    assert gallery.base.application("job1", gallery.environment.model.syntax)[0].flows[0].steps[0].onikon.name == "open"


def test_what_comes_with_onika_is_saved_as_a_copy(tmp_path):  # R-B07
    gallery = AppFixture(tmp_path)
    doc, before = gallery.do(act.Open(str(SHIPPED[0]))), SHIPPED[0].read_bytes()
    gallery.do(act.Save(doc))
    gallery.do(act.Save(doc))
    assert "over that of boxes" in str(gallery.says[-1].text) and SHIPPED[0].read_bytes() == before
    assert gallery.view(doc).path == str(gallery.site.own / "appl" / SHIPPED[0].name)


def test_one_that_is_not_saved_is_not_closed_by_the_way(gallery):  # R-X01
    doc = gallery.begun("grip")
    no = gallery.no(act.Close(doc))
    assert [str(remedy.label) for remedy in no.remedies] == ["Save it first", "Discard it"]
    gallery.do(no.remedies[1].act)
    assert gallery.environment.tree.applications == {}
    assert str(gallery.no(act.Save(doc)).reason) == "this application is no longer open"


def test_reading_the_file_again_can_be_taken_back(gallery):  # R-X10
    doc, _ = saved(gallery, "grip")
    gallery.add(doc, "open")
    gallery.do(act.Reload(doc))
    assert (gallery.flow(doc), gallery.view(doc).is_dirty) == ("grip", False)
    gallery.do(act.Undo(doc))
    assert (gallery.flow(doc), gallery.view(doc).is_dirty) == ("open grip", True)
    assert "no file yet" in str(gallery.no(act.Reload(gallery.begun())).reason)


def test_keeping_what_is_here_lets_the_next_save_overwrite_the_file(gallery):
    doc, path = saved(gallery, "grip")
    path.write_text(path.read_text() + "# mine\n")
    gallery.add(doc, "open")
    assert "has changed" in str(gallery.no(act.Save(doc)).reason)
    gallery.do(act.Keep(doc))
    gallery.do(act.Save(doc))
    assert gallery.base.application("job1", gallery.environment.model.syntax)[0].flows[0].steps[0].onikon.name == "open"


def test_undo_keeps_the_name_under_which_it_was_saved(gallery):  # R-X10
    doc, _ = saved(gallery, "grip", "open")
    gallery.do(act.Undo(doc))
    assert (gallery.view(doc).name, gallery.view(doc).is_dirty) == ("job1", True)
    gallery.do(act.Redo(doc))
    assert not gallery.view(doc).is_dirty


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_a_file_that_is_edited_back_and_saved_is_the_same_byte_for_byte(tmp_path, path):  # R-B01, R-D14
    base = tmp_path / "base"
    shutil.copytree(shipped() / "boxes", base)
    site = Site(
        tuple(map(type(AppFixture(tmp_path).base), (base, shipped() / "puma", shipped() / "generic"))),
        shipped() / "prefs",
    )
    model, _ = opened(site, None, {})
    sitting = EnvironmentFixture(base, (), model)
    file = base / "appl" / path.name
    before = file.read_bytes()
    doc = sitting.do(act.Open(str(file)))
    number = sitting.do(act.InsertIcon(doc, "opengripC"))
    sitting.do(act.Save(doc))
    assert file.read_bytes() != before
    sitting.do(act.Undo(doc))
    sitting.do(act.Save(doc))
    assert file.read_bytes() == before
    assert number


def broken(gallery, change):
    """A saved file that somebody broke by hand; it, and its text."""
    doc, path = saved(gallery, "move", "there", "grip")
    gallery.do(act.Close(doc))
    text = change(path.read_text())
    path.write_text(text)
    return path, text


def test_a_broken_file_opens_as_far_as_it_can_be_read_with_its_faults(gallery):  # issue: bad input
    path, text = broken(
        gallery, lambda text: text.replace("MARKER      no", "MARKER      maybe", 1).replace("EOF\n", "")
    )
    doc = gallery.do(act.Open(str(path)))
    assert gallery.flow(doc) == "move there grip"
    faults = list(gallery.view(doc).faults.values())
    assert [fault.level for fault in faults] == ["fault", "fault"]
    assert "expected yes or no after MARKER" in str(faults[0].text)
    assert faults[0].step == gallery.number(doc, "move")
    assert gallery.environment.model.applications[doc].is_partial
    no = gallery.no(act.Save(doc))
    assert "would be lost" in str(no.reason)
    assert path.read_text() == text
    gallery.do(no.remedies[-1].act)
    assert gallery.view(doc).faults == {}
    assert gallery.base.application("job1", gallery.environment.model.syntax)[0] is not None


def test_an_icon_that_cannot_be_read_leaves_a_hole_that_keeps_its_lines(gallery):
    lines = "UI          0.1 0.2 0.3 0.4 0.5 0.6"
    path, _ = broken(gallery, lambda text: text.replace(lines, "UI          0.1 many 0.3 0.4 0.5 0.6", 1))
    doc = gallery.do(act.Open(str(path)))
    assert gallery.flow(doc) == "move _ grip"
    gallery.do(act.Save(doc, overwrites=True))
    assert "0.1 many 0.3" in path.read_text()


def test_a_copy_of_what_could_be_read_loses_nothing_and_needs_no_word(gallery):
    path, text = broken(gallery, lambda text: text.replace("ENDFLOW", "", 1))
    doc = gallery.do(act.Open(str(path)))
    gallery.do(act.Save(doc, "copy", str(gallery.base.path)))
    assert path.read_text() == text
    assert not gallery.environment.model.applications[doc].is_partial


@pytest.mark.parametrize("text", ["", "VERSION 9.9\nFLOW\nENDFLOW\nEOF\n", "VERSION 1.3\nEOF\n", "\x80\xff"])
def test_a_file_of_which_nothing_can_be_read_is_refused_with_the_reason(gallery, text):
    path = gallery.base.application_file("none")
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(text.encode("latin-1"))
    assert "cannot be opened" in str(gallery.no(act.Open(str(path))).reason)


STRANGE = """VERSION     2.0

APPLTYPE    conditional

FLOW

ROUTINE     warp
MARKER      yes
MARKERIF    LAMP == 1
ONIKON      Warp job
DESC        go there at once
UI          none
{picture}
ROUTINE     mars
MARKER      no
ONIKON      Warp object
DESC        mars
UI          4 5
{picture}
ENDFLOW

EOF
"""


def test_unknown_types_and_conditions_outlast_opening_editing_and_saving(gallery):  # R-D16
    picture = "".join(f"PICT        {'8' * 32}\n" for _ in range(32))
    path = gallery.base.application_file("strange")
    path.parent.mkdir(exist_ok=True)
    path.write_text(STRANGE.format(picture=picture))
    doc = gallery.do(act.Open(str(path)))
    assert gallery.flow(doc) == "warp _"
    assert gallery.step(doc, "warp").break_if == "LAMP == 1"
    number = gallery.do(act.InsertIcon(doc, "grip"))
    gallery.do(act.RemoveIcons(doc, (number,)))
    gallery.do(act.Save(doc))
    assert path.read_text() == STRANGE.format(picture=picture)
    gallery.do(act.RemoveIcons(doc, (gallery.number(doc, "_"),)))
    assert gallery.flow(doc) == "warp"
