import os

import pytest

from onika.desk.environment.file.disk_watch import DiskWatch, bases
from onika.desk.environment.state.model import Model
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site


@pytest.fixture
def base(tmp_path):
    for folder in ("module", "conf", "dict"):
        (tmp_path / "base" / folder).mkdir(parents=True)
    (tmp_path / "base" / "module" / "a.rmod").write_text("a")
    return tmp_path / "base"


@pytest.fixture
def disk(base):
    return DiskWatch(Site((BaseDirectory(base),), shipped() / "prefs"))


def test_nothing_has_changed_where_nobody_has_written(disk):
    assert disk.changed(Model()) == set()


def test_what_is_written_made_or_removed_is_told_once(disk, base):  # R-C01
    (base / "module" / "a.rmod").write_text("bb")
    (base / "module" / "m.py").write_text("")
    (base / "conf" / "c.conf").write_text("")
    assert disk.changed(Model()) == {base / "module" / "a.rmod", base / "module" / "m.py", base / "conf" / "c.conf"}
    assert disk.changed(Model()) == set()
    (base / "module" / "a.rmod").unlink()
    assert disk.changed(Model()) == {base / "module" / "a.rmod"}
    assert disk.changed(Model()) == set()


def test_a_file_of_the_same_size_and_time_that_was_exchanged_is_another(disk, base):  # R-B07
    path, fresh = base / "module" / "a.rmod", base / "module" / ".a.saving"
    former = path.stat()
    fresh.write_text("b")
    os.utime(fresh, ns=(former.st_atime_ns, former.st_mtime_ns))
    fresh.rename(path)
    assert disk.changed(Model()) == {path}


def test_files_that_are_none_of_ours_are_not_looked_at(disk, base):
    for name in ("notes.txt", ".hidden.rmod", "x.rmod~", ".a.rmod.saving", "c.conf"):
        (base / "module" / name).write_text("")
    (base / "dict" / "d.conf").write_text("")
    assert disk.changed(Model()) == set()


def test_a_folder_that_comes_and_goes_is_told_file_by_file(disk, base, tmp_path):
    (base / "module").rename(tmp_path / "away")
    assert disk.changed(Model()) == {base / "module" / "a.rmod"}
    (tmp_path / "away").rename(base / "module")
    assert disk.changed(Model()) == {base / "module" / "a.rmod"}


def test_a_folder_that_cannot_be_looked_into_for_now_has_not_changed(disk, base, monkeypatch):  # R-C20
    def broken(_path):
        raise OSError(5, "Input/output error")

    with monkeypatch.context() as patched:
        patched.setattr(os, "scandir", broken)
        assert disk.changed(Model()) == set()
    assert disk.changed(Model()) == set()


def test_a_link_is_what_it_leads_to(disk, base, tmp_path):
    (tmp_path / "real.py").write_text("x")
    (base / "module" / "m.py").symlink_to(tmp_path / "real.py")
    (base / "module" / "lost.py").symlink_to(tmp_path / "nowhere")
    (base / "module" / "loop.py").symlink_to(base / "module" / "loop.py")
    assert disk.changed(Model()) == {base / "module" / "m.py"}
    (tmp_path / "real.py").write_text("yy")
    assert disk.changed(Model()) == {base / "module" / "m.py"}


def test_all_files_of_a_base_directory_that_is_new_are_told(disk, tmp_path, base):  # R-C01
    from onika.desk.environment.state.content import Content
    from onika.desk.environment.state.document import Document
    from onika.model.configuration import Configuration

    (tmp_path / "far" / "conf").mkdir(parents=True)
    (tmp_path / "far" / "conf" / "c.conf").write_text("")
    model = Model().with_document(Document("c1", Content(Configuration("c")), base=tmp_path / "far"))
    assert list(bases(Site((BaseDirectory(base),), shipped()), model)) == [base, tmp_path / "far"]
    assert disk.changed(model) == {tmp_path / "far" / "conf" / "c.conf"}
    assert disk.changed(model) == set()


def test_what_defines_the_syntax_is_looked_at_too(base, tmp_path):  # R-D02
    (tmp_path / "home").mkdir()
    (tmp_path / "prefs").mkdir()
    disk = DiskWatch(Site((BaseDirectory(base),), tmp_path / "prefs", tmp_path / "home"))
    own, shared = tmp_path / "home" / ".OnikaUpperSetUp.dta", tmp_path / "prefs" / "OnikaUpperSetUp.dta"
    own.write_text("")
    assert disk.changed(Model()) == {own}
    own.unlink()
    shared.write_text("")
    assert disk.changed(Model()) == {own, shared}
    assert disk.changed(Model()) == set()


def test_icons_and_applications_are_looked_at_too(disk, base):  # R-D01
    (base / "dict" / "d.onk").write_text("")
    (base / "appl").mkdir()
    (base / "appl" / "a.appl").write_text("")
    assert disk.changed(Model()) == {base / "dict" / "d.onk", base / "appl" / "a.appl"}
