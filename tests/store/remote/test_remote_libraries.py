from dataclasses import replace
from datetime import timedelta
from pathlib import Path

import pytest

from kit.labs.library_site import TODAY, LibrarySite, libraries_of, new_key, taken, wink
from onika.files.library_lock import Agreement, LockedLibrary
from onika.store.remote.checkout import is_fetched
from onika.store.remote.publication import fingerprint_of
from onika.store.remote.remote_libraries import NewerVersion, Offer, RemoteLibraries
from onika.words.fault import Refusal
from onika.words.reason import Reason


@pytest.fixture
def site(tmp_path: Path) -> LibrarySite:
    site = LibrarySite(tmp_path)
    site.publish()
    return site


@pytest.fixture
def libraries(tmp_path: Path, site: LibrarySite) -> RemoteLibraries:
    return taken(tmp_path, site)


def locked(libraries: RemoteLibraries, name: str = "wings") -> LockedLibrary:
    library = libraries.find(name)
    assert library is not None
    return library


def renewal_key(libraries: RemoteLibraries, today=TODAY) -> str:
    """Why there is no renewal; "" where there is one."""
    renewal = libraries.renewal(locked(libraries), today)
    return renewal.key if isinstance(renewal, Reason) else ""


def renew(libraries: RemoteLibraries) -> LockedLibrary:
    renewal = libraries.renewal(locked(libraries), TODAY)
    assert isinstance(renewal, NewerVersion), renewal
    renewed = libraries.renew(locked(libraries), renewal)
    assert isinstance(renewed, LockedLibrary)
    return renewed


def code_of(site: LibrarySite, part: bytes = b"class Wink") -> Path:
    """The object of the site that holds a piece of code."""
    return next(path for path in (site.folder / "objects").iterdir() if part in path.read_bytes())


def test_a_library_is_listed_whole_before_anything_of_its_code_is_fetched(libraries, site):  # R-F03
    checkout = libraries.checkout(locked(libraries))
    assert (checkout.folder / "module/wink.rmod").read_text() == wink()
    assert not is_fetched(checkout.folder / "module/wink.py")
    assert [file.path for file in checkout.lacking()] == ["module/wink.py"]


def test_what_is_fetched_is_there_offline(libraries, site, tmp_path):  # R-F03
    assert not libraries.fetch(locked(libraries))
    site.folder.rename(tmp_path / "gone")
    checkout = libraries.checkout(locked(libraries))
    assert checkout.put_right() == ()
    assert (checkout.folder / "module/wink.py").read_text() == (site.base / "module/wink.py").read_text()
    assert not libraries.fetch(locked(libraries))


def test_the_lock_names_the_signer_every_file_and_what_was_agreed_to(libraries):  # R-X16
    library = locked(libraries)
    assert library.signer.startswith("SHA256:") and library.trusted == "2026-11-24 ann"
    assert set(library.files) == {"module/wink.py", "module/wink.rmod"}
    assert library.agreed == {"wink": Agreement(frozenset({"LAMP"}))}


# -- the eleven attacks


@pytest.mark.parametrize("at", [100, 310, -20, -1])
def test_a_tampered_index_is_refused(libraries, site, at):  # R-X16
    content = bytearray((site.folder / "library").read_bytes())
    content[at] ^= 1
    site.give(bytes(content))
    assert renewal_key(libraries) in ("store.signature_bad", "store.signature_missing")


def test_an_index_of_an_unknown_signer_is_refused(libraries, site, tmp_path):  # R-X16
    site.give(site.signed(site.index(version=2), new_key(tmp_path, "eve")))
    assert renewal_key(libraries) == "store.signer_other"


def test_an_older_index_is_refused(libraries, site):  # R-X16
    former = (site.folder / "library").read_bytes()
    site.publish()
    renew(libraries)
    site.give(former)
    assert renewal_key(libraries) == "store.index_older"


def test_another_index_of_the_same_version_is_refused(libraries, site):  # R-X16
    site.give(site.signed(site.index({"module/other.rmod": wink()})))
    assert renewal_key(libraries) == "store.version_twice"


def test_an_index_past_its_day_is_no_newest_one_but_what_is_locked_goes_on(libraries):  # R-X16
    assert renewal_key(libraries, TODAY + timedelta(days=400)) == "store.index_overdue"
    assert libraries.checkout(locked(libraries)).put_right() == ()


def test_the_index_of_another_library_is_refused(libraries, site):  # R-X16
    site.give(site.signed(site.index(name="sandia", version=2)))
    assert renewal_key(libraries) == "store.library_other"


def test_a_tampered_file_is_not_kept(libraries, site):  # R-X16
    code = code_of(site)
    code.write_bytes(code.read_bytes().replace(b"1 - ", b"7 - "))
    assert libraries.fetch(locked(libraries)).key == "store.not_as_signed"
    assert not is_fetched(libraries.checkout(locked(libraries)).folder / "module/wink.py")


def test_a_file_that_does_not_end_is_not_read_on(libraries, site):  # R-X16
    code = code_of(site)
    code.write_bytes(code.read_bytes() + b"#" * 1_000_000)
    assert libraries.fetch(locked(libraries)).key == "store.answer_large"


def test_a_tampered_cache_is_noticed_and_put_right(libraries, tmp_path):  # R-X16
    libraries.fetch(locked(libraries))
    checkout = libraries.checkout(locked(libraries))
    code = checkout.folder / "module/wink.py"
    honest = code.read_bytes()
    for path in (code, checkout.folder / "module/wink.rmod"):
        path.chmod(0o600)
        path.write_bytes(b"import os\n")
    (checkout.folder / "module/evil.py").write_text("import os\n")
    (checkout.folder / "conf").symlink_to(tmp_path)
    assert checkout.put_right() == ()
    assert code.read_bytes() == honest
    assert (checkout.folder / "module/wink.rmod").read_text() == wink()
    assert sorted(path.name for path in checkout.folder.rglob("*")) == ["module", "wink.py", "wink.rmod"]
    for kept in (tmp_path / "cache/onika/objects").rglob("*"):
        if kept.is_file():
            kept.write_bytes(b"altered")
    assert [fault.reason.key for fault in checkout.put_right()] == ["store.index_altered"]
    assert not code.exists()


def kept_code(tmp_path, code: bytes) -> Path:
    """The object of the cache that holds this code."""
    objects = (tmp_path / "cache/onika/objects").rglob("*")
    return next(path for path in objects if path.is_file() and path.read_bytes() == code)


def test_an_object_of_the_cache_that_was_changed_is_told_and_fetched_anew(libraries, tmp_path):  # R-X16
    libraries.fetch(locked(libraries))
    checkout = libraries.checkout(locked(libraries))
    code = checkout.folder / "module/wink.py"
    honest = code.read_bytes()
    kept = kept_code(tmp_path, honest)
    kept.write_bytes(honest.replace(b"1 - ", b"7 - "))  # as long as before
    assert checkout.altered() == ("module/wink.py",)
    assert [fault.reason.key for fault in checkout.put_right()] == ["store.kept_altered"]
    assert not is_fetched(code)
    assert not libraries.fetch(locked(libraries))
    assert kept.read_bytes() == honest == code.read_bytes()
    assert checkout.altered() == checkout.put_right() == ()


def test_an_object_of_the_cache_that_was_changed_is_not_all_of_it_here_offline(libraries, site, tmp_path):  # R-X16
    libraries.fetch(locked(libraries))
    honest = (site.base / "module/wink.py").read_bytes()
    kept_code(tmp_path, honest).write_bytes(honest[::-1])
    site.folder.rename(tmp_path / "gone")
    assert libraries.fetch(locked(libraries)).key == "store.not_fetched"
    assert not is_fetched(libraries.checkout(locked(libraries)).folder / "module/wink.py")


def test_files_of_two_versions_are_not_mixed(libraries, site):  # R-X16
    former = code_of(site).read_bytes()
    site.write("module/wink.py", former.decode() + "# another\n")
    site.publish()
    renew(libraries)
    code_of(site, b"# another").write_bytes(former)
    assert libraries.fetch(locked(libraries)).key == "store.not_as_signed"


@pytest.mark.parametrize(
    "path",
    [
        "module/../../.ssh/config.rmod",
        "module/.pd.rmod",
        "../pd.rmod",
        "/etc/pd.rmod",
        "module//pd.rmod",
        "module/pd",
        "module/sub/pd.rmod",
        "bin/pd.rmod",
        "world/a/b/c/d",
        "module/pd.rmod\x00",
        "module/p d.rmod",
        "module/..%2fpd.rmod",
    ],
)
def test_a_path_that_is_none_of_a_library_is_refused(libraries, site, path):  # R-X16
    site.give(site.signed(site.index({path: wink()}, version=2)))
    assert renewal_key(libraries) in ("files.index_path", "files.index_line")


def test_what_a_task_writes_further_is_shown_before_it_is_agreed_to(libraries, site):  # R-X16
    site.write("module/wink.rmod", wink("LAMP", "Q_MEZ"))
    site.publish()
    renewal = libraries.renewal(locked(libraries), TODAY)
    assert isinstance(renewal, NewerVersion)
    assert renewal.changes.further == {"wink": Agreement(frozenset({"Q_MEZ"}))}
    assert renewal.changes.altered == ("module/wink.rmod",)


def test_a_task_that_writes_what_nobody_agreed_to_is_left_out(libraries):  # R-X16
    narrow = replace(locked(libraries), agreed={"wink": Agreement()})
    faults = libraries.checkout(narrow).put_right()
    assert [fault.reason.key for fault in faults] == ["store.writes_further"]
    assert not (libraries.checkout(narrow).folder / "module/wink.rmod").exists()


# -- names, keys, clocks, others


def test_a_clock_that_is_wrong_by_an_hour_changes_nothing(libraries):  # R-X16
    assert renewal_key(libraries, TODAY + timedelta(hours=1)) == ""


def test_a_second_library_of_one_name_is_refused(libraries, site, tmp_path):  # R-X16
    (tmp_path / "eve").mkdir()
    other = LibrarySite(tmp_path / "eve")
    other.publish()
    offer = libraries.offer(str(other.folder), TODAY)
    assert isinstance(offer, Offer)
    refused = libraries.add(offer, "")
    assert isinstance(refused, Refusal) and refused.reason.key == "store.library_known"
    assert locked(libraries).address == str(site.folder)


def test_a_key_that_its_predecessor_has_announced_is_trusted(libraries, site, tmp_path):  # R-X16
    young = new_key(tmp_path, "young")
    fingerprint = fingerprint_of(young.with_suffix(".pub"))
    site.publish(next_key=fingerprint)
    renew(libraries)
    site.key = young
    site.publish()
    assert renew(libraries).signer == fingerprint


def test_another_key_is_trusted_where_the_user_says_so(libraries, site, tmp_path):  # R-X16
    site.key = new_key(tmp_path, "other")
    publication = site.publish()
    assert renewal_key(libraries) == "store.signer_other"
    libraries.trust(locked(libraries), publication.signer, "2026-11-25 ann")
    assert renewal_key(libraries) == ""


def test_what_is_removed_is_gone_and_others_stay(libraries, tmp_path):  # R-F03
    other = LibrarySite(tmp_path, "second")
    other.publish()
    offer = libraries.offer(str(other.folder), TODAY)
    assert isinstance(offer, Offer)
    libraries.add(offer, "")
    folder = libraries.checkout(locked(libraries)).folder
    assert libraries.remove("wings") is None
    assert not folder.exists()
    assert [library.name for library in libraries.listed()[0]] == ["second"]
    refused = libraries.remove("wings")
    assert refused is not None and refused.reason.key == "store.library_unknown"


def test_nothing_is_kept_of_a_library_that_is_only_looked_at(tmp_path, site):  # R-X16
    libraries = libraries_of(tmp_path)
    assert isinstance(libraries.offer(str(site.folder), TODAY), Offer)
    assert not libraries.lock.path.exists()
    assert not (tmp_path / "cache").exists()
