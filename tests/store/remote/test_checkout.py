from kit.labs.library_site import LibrarySite, taken
from onika.store.remote.checkout import Checkout, is_fetched
from onika.store.remote.checkout_path import is_checked_out
from onika.store.shipped import is_shipped


def checkout(tmp_path) -> Checkout:
    site = LibrarySite(tmp_path)
    site.write("conf/winkC.conf", "VERSION 1.3\nEOF\n")
    site.publish()
    libraries = taken(tmp_path, site)
    return libraries.checkout(libraries.listed()[0][0])


def test_a_library_stands_in_a_folder_of_its_name_that_nobody_writes(tmp_path):  # R-F03
    files = checkout(tmp_path)
    assert files.folder.name == "wings"
    assert is_checked_out(files.folder) and is_shipped(files.folder / "module/wink.rmod")
    assert not is_checked_out(tmp_path / "home" / "onika")
    assert (files.folder / "conf/winkC.conf").stat().st_mode & 0o777 == 0o400


def test_putting_right_what_is_right_writes_nothing(tmp_path):  # R-F03
    files = checkout(tmp_path)
    before = {path: path.stat().st_ino for path in files.folder.rglob("*")}
    assert files.put_right() == ()
    assert {path: path.stat().st_ino for path in files.folder.rglob("*")} == before


def test_a_folder_in_place_of_a_file_is_replaced(tmp_path):  # R-X16
    files = checkout(tmp_path)
    (files.folder / "conf/winkC.conf").unlink()
    (files.folder / "conf/winkC.conf").mkdir()
    (files.folder / "conf/winkC.conf/x").write_text("x")
    assert files.put_right() == ()
    assert (files.folder / "conf/winkC.conf").read_text() == "VERSION 1.3\nEOF\n"


def test_a_link_in_place_of_a_folder_is_not_followed(tmp_path):  # R-X16
    files = checkout(tmp_path)
    elsewhere = tmp_path / "elsewhere"
    (files.folder / "module").rename(elsewhere)
    (files.folder / "module").symlink_to(elsewhere)
    assert files.put_right() == ()
    assert not (files.folder / "module").is_symlink()
    assert (files.folder / "module/wink.rmod").is_file()


def test_code_that_is_not_fetched_says_so(tmp_path):  # R-F03
    files = checkout(tmp_path)
    code = files.folder / "module/wink.py"
    assert not is_fetched(code)
    assert "onika library fetch wings" in code.read_text()
    assert is_fetched(tmp_path / "wings/module/wink.py")


def test_a_file_that_the_lock_names_otherwise_is_left_out(tmp_path):  # R-X16
    files = checkout(tmp_path)
    del files.locked.files["conf/winkC.conf"]  # type: ignore[attr-defined]
    assert [fault.reason.key for fault in files.put_right()] == ["store.not_as_locked"]
    assert not (files.folder / "conf/winkC.conf").exists()
