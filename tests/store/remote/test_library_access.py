from pathlib import Path

import pytest

from kit.labs.library_server import LibraryServer
from kit.labs.library_site import LibrarySite
from onika.store.remote.credential import Credential
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.object_cache import ObjectCache
from onika.words.reason import Reason


@pytest.fixture
def site(tmp_path: Path) -> LibrarySite:
    site = LibrarySite(tmp_path)
    site.publish()
    return site


def access(tmp_path: Path, ask=None) -> LibraryAccess:
    return LibraryAccess(ObjectCache(tmp_path / "cache"), tmp_path / "state", ask)


def test_a_password_is_asked_for_once(tmp_path, site):  # R-F03
    asked = []

    def ask(host: str, why: Reason) -> Credential:
        asked.append(why.key)
        return Credential("secret", "ann")

    with LibraryServer(site.folder, password="ann:secret") as server:
        ours = access(tmp_path, ask)
        assert isinstance(ours.index(server.address), bytes)
        assert isinstance(ours.index(server.address), bytes)
        ours.close()
    assert asked == ["store.password_needed"]


def test_a_wrong_password_is_asked_for_three_times_and_no_more(tmp_path, site):  # R-X16
    asked = []

    def ask(host: str, why: Reason) -> Credential:
        asked.append(why.key)
        return Credential("wrong", "ann")

    with LibraryServer(site.folder, password="ann:secret") as server:
        ours = access(tmp_path, ask)
        reason = ours.index(server.address)
        ours.close()
    assert isinstance(reason, Reason) and reason.key == "store.password_wrong"
    assert asked == ["store.password_needed", "store.password_wrong", "store.password_wrong"]


def test_a_kept_token_is_used_without_asking(tmp_path, site):  # R-F03
    (tmp_path / "state/library-tokens").mkdir(parents=True)
    (tmp_path / "state/library-tokens/127.0.0.1").write_text("ann:secret\n")
    with LibraryServer(site.folder, password="ann:secret") as server:
        ours = access(tmp_path)
        assert isinstance(ours.index(server.address), bytes)
        ours.close()


def test_nobody_who_can_be_asked_is_a_reason(tmp_path, site):  # R-F03
    with LibraryServer(site.folder, password="ann:secret") as server:
        ours = access(tmp_path)
        reason = ours.index(server.address)
        ours.close()
    assert isinstance(reason, Reason) and reason.key == "store.password_needed"


def test_a_former_index_is_brought_by_its_digest(tmp_path, site):  # R-F03
    former = (site.folder / "library").read_bytes()
    ours = access(tmp_path)
    digest = ObjectCache(tmp_path / "other").put(former)
    site.publish()
    assert not ours.pinned_index(str(site.folder), digest)
    assert ours.cache.get(digest) == former
