import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.file.file_acts import KINDS
from onika.desk.environment.state.open_file import DocumentKind
from onika.wire import act

BLANK = {DocumentKind.CONFIGURATION: act.New(), DocumentKind.APPLICATION: act.NewApplication()}


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


@pytest.fixture(params=list(DocumentKind), ids=lambda kind: kind.value)
def kind(request):
    return request.param


@pytest.fixture
def doc(gallery, kind):
    return gallery.do(BLANK[kind])


def save(gallery, doc, name="mine", **how):
    return act.Save(doc, name, str(gallery.base.path), **how)


def test_every_kind_of_files_can_be_opened_and_saved():
    assert set(KINDS) == set(DocumentKind)


def test_whatever_is_open_is_saved_under_a_name_and_opened_by_its_file(gallery, kind, doc):  # R-C06, R-D04
    path = gallery.do(save(gallery, doc))
    assert gallery.do(act.Open(path)) == doc
    gallery.do(act.Close(doc))
    again = gallery.do(act.Open(path))
    assert again != doc and DocumentKind.of(again) is kind
    assert gallery.environment.model.file(again).name == "mine"


def test_a_name_that_is_none_is_refused_at_its_field(gallery, doc):  # R-X01
    no = gallery.no(save(gallery, doc, "no name"))
    assert str(no.reason) == "'no name' is no name for a file" and "name" in no.fields


def test_what_has_no_file_is_not_read_again(gallery, doc):
    assert str(gallery.no(act.Reload(doc)).reason).endswith("has no file yet")


def test_a_file_that_another_has_written_is_overwritten_once_what_is_here_is_kept(gallery, doc, kind):  # R-B07
    path = gallery.do(save(gallery, doc))
    folder = gallery.base
    file = folder.application_file("mine") if kind is DocumentKind.APPLICATION else folder.configuration_file("mine")
    file.write_text(file.read_text() + "\n")
    assert [str(remedy.label) for remedy in gallery.no(act.Save(doc)).remedies][-1] == "Save as…"
    gallery.do(act.Keep(doc))
    assert gallery.do(act.Save(doc)) == path


@pytest.mark.parametrize("wish", [act.Save, act.Close, act.Reload, act.Keep], ids=lambda wish: wish.__name__)
def test_what_somebody_else_has_closed_is_told_by_its_kind(gallery, wish):
    assert str(gallery.no(wish("c99")).reason) == "this configuration is no longer open"
    assert str(gallery.no(wish("a99")).reason) == "this application is no longer open"
