from kit.labs.library_site import TODAY, LibrarySite, taken, wink
from onika.files.library_lock import Agreement
from onika.store.remote.library_changes import LibraryChanges, changes


def test_what_came_changed_and_went_is_named(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    site.publish()
    locked = taken(tmp_path, site).listed()[0][0]
    assert changes(locked, site.publish().index) == LibraryChanges(1, 2, further={})
    assert changes(locked, site.publish().index).is_empty
    (site.base / "module/wink.py").unlink()
    site.write("module/wink.rmod", wink("LAMP", "SHADE"))
    site.write("module/blink.rmod", wink("LAMP"))
    new = changes(locked, site.publish().index)
    assert (new.added, new.altered, new.gone) == (("module/blink.rmod",), ("module/wink.rmod",), ("module/wink.py",))
    assert new.further == {"wink": Agreement(frozenset({"SHADE"}))}


def test_a_task_that_went_and_comes_again_writes_no_more_unasked(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    site.write("module/glow.rmod", wink("SHADE"))
    site.publish()
    libraries = taken(tmp_path, site)
    (site.base / "module/wink.rmod").unlink()
    site.publish()
    locked = libraries.listed()[0][0]
    libraries.renew(locked, libraries.renewal(locked, TODAY))
    site.write("module/wink.rmod", wink("SHADE", "T_REF"))
    new = changes(libraries.listed()[0][0], site.publish().index)
    assert new.further == {"wink": Agreement(frozenset({"T_REF"}))}


def test_a_task_whose_file_could_not_be_read_is_agreed_to_when_it_can(tmp_path):  # R-X16
    site = LibrarySite(tmp_path)
    site.write("module/wink.rmod", wink("T_REF").removesuffix("EOF\n"))
    site.publish()
    locked = taken(tmp_path, site).listed()[0][0]
    site.write("module/wink.rmod", wink("T_REF"))
    assert changes(locked, site.publish().index).further == {"wink": Agreement(frozenset({"T_REF"}))}
