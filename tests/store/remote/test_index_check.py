from hashlib import sha256

import pytest
import zstandard

from kit.labs.library_site import LibrarySite, new_key, taken
from onika.files import library_index
from onika.store.remote.index_check import SignedIndex, opened, reopened, unpacked
from onika.store.remote.signature import sign
from onika.words.reason import Reason


@pytest.fixture
def site(tmp_path) -> LibrarySite:
    return LibrarySite(tmp_path)


def test_a_signed_index_is_opened_and_its_signer_named(site):  # R-X16
    content = site.signed(site.index())
    found = opened(content)
    assert isinstance(found, SignedIndex)
    assert found.index == site.index()
    assert found.digest == sha256(content).hexdigest()
    assert found.signer.startswith("SHA256:")


def test_nothing_is_unpacked_before_its_signature_is_good(site, tmp_path, monkeypatch):  # R-X16
    content = site.signed(site.index())
    monkeypatch.setattr("onika.store.remote.index_check.unpacked", None)
    altered = content[:-1] + bytes([content[-1] ^ 1])
    refused = opened(altered)
    assert isinstance(refused, Reason) and refused.key == "store.signature_bad"


def test_a_packed_index_of_too_much_is_not_unpacked(monkeypatch):  # R-X16
    monkeypatch.setattr(library_index, "LARGEST_TEXT", 1000)
    bomb = zstandard.compress(b"x" * 10_000_000)
    assert len(bomb) < 2000
    refused = unpacked(bomb)
    assert isinstance(refused, Reason) and refused.key == "store.index_large"
    assert unpacked(zstandard.compress(b"x" * 1000)) == b"x" * 1000


@pytest.mark.parametrize("body", [b"", b"plain text", zstandard.compress(b"x" * 5000)[:-9]])
def test_what_is_no_packed_index_is_refused(tmp_path, body):  # R-X16
    content = sign(body, new_key(tmp_path))
    assert isinstance(content, bytes)
    assert isinstance(opened(content), Reason)


def test_a_locked_index_is_known_by_what_it_holds(site, tmp_path):  # R-X16
    site.publish()
    locked = taken(tmp_path, site).listed()[0][0]
    content = (site.folder / "library").read_bytes()
    found = reopened(content, locked)
    assert isinstance(found, SignedIndex)
    altered = reopened(content + b"x", locked)
    assert isinstance(altered, Reason) and altered.key == "store.index_altered"
