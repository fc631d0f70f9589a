from dataclasses import replace
from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory, job
from kit.labs.library_server import LibraryServer
from kit.labs.library_site import TODAY, LibrarySite, taken, wink
from onika.store.program import load
from onika.store.remote.checkout import is_fetched
from onika.store.remote.library_fetcher import LibraryFetcher, checkouts_of
from onika.store.remote.remote_libraries import RemoteLibraries
from onika.store.site import Site, open_site


@pytest.fixture
def site(tmp_path: Path) -> LibrarySite:
    site = LibrarySite(tmp_path)
    site.write("module/unused.rmod", wink().replace("MODULE      wink", "MODULE      unused"))
    site.write("module/unused.py", "# of nobody\n")
    site.write("robot/arm.xml", "<mujoco/>")
    Laboratory(site.base).configuration("winkC", "wink 50")
    Laboratory(site.base).application("evening", [job("winkC")])
    site.publish()
    return site


def here(tmp_path: Path) -> Site:
    return open_site([], {"XDG_CACHE_HOME": str(tmp_path / "cache")}, tmp_path / "home")


def fetching(site: Site, libraries: RemoteLibraries) -> Site:
    return replace(site, fetcher=LibraryFetcher(site.checkouts, libraries.access))


def test_a_library_stands_behind_all_that_is_here(tmp_path, site):  # R-C01 R-X16
    site.write("module/pd.rmod", wink().replace("MODULE      wink", "MODULE      pd"))
    site.publish()
    taken(tmp_path, site)
    search_path = here(tmp_path)
    assert search_path.directories[-1].path.name == "wings"
    home = search_path.home_of_task("pd")
    assert home is not None and home.path.name == "generic"
    home = search_path.home_of_task("wink")
    assert home is not None and home.path.name == "wings"


def test_a_program_fetches_its_own_code_at_once_and_no_other(tmp_path, site):  # R-F03 R-F11
    with LibraryServer(site.folder) as server:
        libraries = taken(tmp_path, site, server.address)
        server.asked.clear()
        search_path = fetching(here(tmp_path), libraries)
        types, _ = search_path.syntax()
        path = search_path.application_file("evening")
        assert types is not None and path is not None
        program, faults = load(path, search_path, types)
        libraries.access.close()
    assert program is not None and faults == ()
    assert program.code["wink"].read_text() == (site.base / "module/wink.py").read_text()
    folder = search_path.directories[-1].path
    assert (folder / "robot/arm.xml").is_file()
    assert not is_fetched(folder / "module/unused.py")
    assert len(server.asked) == 2
    assert load(path, search_path, types)[1] == ()  # the server is gone: nobody is asked again


def test_a_program_whose_code_cannot_be_fetched_is_told_and_not_run(tmp_path, site):  # R-X16
    libraries = taken(tmp_path, site)
    site.folder.rename(tmp_path / "gone")
    search_path = fetching(here(tmp_path), libraries)
    types, _ = search_path.syntax()
    path = search_path.application_file("evening")
    assert types is not None and path is not None
    _, faults = load(path, search_path, types)
    assert [(fault.reason.key, fault.is_note) for fault in faults] == [
        ("store.not_fetched", True),
        ("store.code_not_fetched", False),
    ]


def test_code_that_was_changed_in_the_cache_is_told_and_fetched_anew_or_not_run(tmp_path, site):  # R-X16
    libraries = taken(tmp_path, site)
    libraries.fetch(libraries.listed()[0][0])
    honest = (site.base / "module/wink.py").read_bytes()
    objects = (tmp_path / "cache/onika/objects").rglob("*")
    kept = next(path for path in objects if path.is_file() and path.read_bytes() == honest)
    for is_there in (True, False):
        kept.write_bytes(honest.replace(b"1 - ", b"7 - "))
        if not is_there:
            site.folder.rename(tmp_path / "gone")
        search_path = fetching(here(tmp_path), libraries)
        assert [fault.reason.key for fault in search_path.faults_of_checkouts] == ["store.kept_altered"]
        types, _ = search_path.syntax()
        path = search_path.application_file("evening")
        assert types is not None and path is not None
        program, faults = load(path, search_path, types)
        if is_there:
            assert program is not None and program.code["wink"].read_bytes() == honest and faults == ()
        else:
            assert [fault.reason.key for fault in faults if not fault.is_note] == ["store.code_not_fetched"]


def test_a_lock_at_fault_leaves_everything_else_as_it_is(tmp_path, site):  # R-X16
    taken(tmp_path, site)
    (tmp_path / "home/onika/onika.lock").write_text("VERSION 2.0\nLIBRARY wings\n")
    search_path = here(tmp_path)
    assert search_path.checkouts == ()
    assert search_path.faults_of_checkouts and all(fault.is_note for fault in search_path.faults_of_checkouts)
    assert search_path.home_of_task("pd") is not None


def test_two_locks_with_two_versions_are_told_and_the_first_counts(tmp_path, site):  # R-X16
    libraries = taken(tmp_path, site)
    (tmp_path / "far").mkdir()
    site.publish()
    other = taken(tmp_path / "far", site)
    bases = (libraries.lock.base, other.lock.base)
    checkouts, faults = checkouts_of(bases, libraries.access.cache)
    assert [checkout.locked.version for checkout in checkouts] == [1]
    assert [fault.reason.key for fault in faults] == ["store.library_twice"]
    assert checkouts[0].locked.until > TODAY
