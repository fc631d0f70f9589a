from kit.labs.library_site import LibrarySite, taken, wink
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
