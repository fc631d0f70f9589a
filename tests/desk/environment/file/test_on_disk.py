import pytest

from kit.desk.app_fixture import AppFixture
from onika.desk.environment.refresh import refreshed
from onika.wire import act


@pytest.fixture
def gallery(tmp_path):
    return AppFixture(tmp_path)


def opened(gallery):
    doc = gallery.begun("grip", "open")
    path = gallery.do(act.Save(doc, "job1", str(gallery.base.path)))
    return doc, gallery.base.application_file("job1"), path


def look(gallery, path):
    gallery.environment.become(lambda model: refreshed(model, {path}))


def swapped(path):
    """The same icons the other way round."""
    head, first, two = path.read_text().split("ROUTINE")
    two, end = two.split("ENDFLOW")
    path.write_text(f"{head}ROUTINE{two}ROUTINE{first}ENDFLOW{end}")


def test_a_file_that_others_changed_is_read_again_where_nothing_is_lost(gallery):  # R-X10
    doc, path, _ = opened(gallery)
    swapped(path)
    look(gallery, path)
    assert gallery.flow(doc) == "open grip"
    assert not gallery.view(doc).is_dirty
    assert "read again" in str(gallery.says[-1].text)
    gallery.do(act.Undo(doc))
    assert gallery.flow(doc) == "grip open"


def test_what_is_not_saved_here_stays_and_it_is_told(gallery):  # R-X10
    doc, path, _ = opened(gallery)
    gallery.add(doc, "wait")
    swapped(path)
    look(gallery, path)
    assert gallery.view(doc).has_changed_on_disk
    assert gallery.flow(doc) == "wait grip open"
    gallery.do(act.Reload(doc))
    assert (gallery.flow(doc), gallery.view(doc).has_changed_on_disk) == ("open grip", False)


def test_what_was_saved_here_is_nothing_new(gallery):
    doc, path, _ = opened(gallery)
    before = gallery.environment.model.applications
    look(gallery, path)
    assert gallery.environment.model.applications is before
    assert gallery.view(doc).path == str(path)


def test_a_file_that_is_gone_or_broken_is_told(gallery):
    doc, path, _ = opened(gallery)
    text = path.read_text()
    path.write_text("")
    look(gallery, path)
    assert gallery.view(doc).has_changed_on_disk
    path.write_text(text)
    look(gallery, path)
    assert not gallery.view(doc).has_changed_on_disk
    path.unlink()
    look(gallery, path)
    assert gallery.view(doc).has_changed_on_disk
    assert "was removed" in str(gallery.says[-1].text)


def test_a_file_broken_in_part_is_shown_as_far_as_it_goes(gallery):
    doc, path, _ = opened(gallery)
    path.write_text(path.read_text().replace("EOF", ""))
    look(gallery, path)
    assert gallery.flow(doc) == "grip open"
    assert [fault.level for fault in gallery.view(doc).faults.values()] == ["fault"]
