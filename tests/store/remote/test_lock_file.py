from kit.labs.library_site import LibrarySite, taken
from onika.store.remote.lock_file import LockFile


def test_a_lock_stands_in_its_base_directory(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    site.publish()
    lock = taken(tmp_path, site).lock
    assert lock.path == tmp_path / "home" / "onika" / "onika.lock"
    assert [library.name for library in lock.libraries()[0]] == ["wings"]


def test_where_there_is_none_nothing_is_locked(tmp_path):  # R-X16
    assert LockFile(tmp_path).libraries() == ((), ())


def test_a_lock_that_somebody_else_has_written_meanwhile_is_not_overwritten(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    site.publish()
    lock = taken(tmp_path, site).lock
    opened, _ = lock.opened()
    lock.path.write_text(lock.path.read_text() + "# mine\n")
    refused = lock.saved((), opened)
    assert refused is not None and refused.reason.key == "files.changed_since"
