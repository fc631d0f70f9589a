import subprocess
import sys

import pytest

from kit.labs.library_site import new_key
from onika.store.remote.signature import NAMESPACE, Signature, fault, parted, sign
from onika.words.reason import Reason

NO_PROGRAM = "no-such-program"


def signed(tmp_path, body: bytes = b"body", namespace: str = NAMESPACE) -> tuple[Signature, bytes]:
    content = sign(body, new_key(tmp_path), namespace=namespace)
    assert isinstance(content, bytes)
    both = parted(content)
    assert not isinstance(both, Reason)
    return both


def test_a_signature_is_good_for_what_was_signed_only(tmp_path):  # R-X16
    signature, body = signed(tmp_path)
    assert body == b"body"
    assert not fault(signature, body)
    assert fault(signature, b"bodY").key == "store.signature_bad"


def test_the_signature_of_another_thing_is_none_of_a_library(tmp_path):  # R-X16
    signature, body = signed(tmp_path, namespace="onika-card")
    assert fault(signature, body).key == "store.signature_of_other"
    assert not fault(signature, body, namespace="onika-card")


def test_a_signature_under_another_key_is_not_good(tmp_path):  # R-X16
    signature, body = signed(tmp_path)
    (tmp_path / "other").mkdir()
    other, _ = signed(tmp_path / "other")
    forged = Signature(other.text, signature.key, signature.namespace, signature.hash_name, signature.signed)
    assert fault(forged, body).key == "store.signature_bad"


@pytest.mark.parametrize("kind", [("rsa", "-b", "2048"), ("ecdsa",)])
def test_other_keys_of_ssh_sign_too(tmp_path, kind):  # R-X16
    key = tmp_path / "key"
    subprocess.run(["ssh-keygen", "-q", "-t", *kind, "-N", "", "-f", key], check=True)
    content = sign(b"body", key)
    assert isinstance(content, bytes)
    both = parted(content)
    assert not isinstance(both, Reason)
    assert not fault(*both)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"body",
        b"-----BEGIN SSH SIGNATURE-----\n\n-----END SSH SIGNATURE-----\nbody",
        b"-----BEGIN SSH SIGNATURE-----\nU1NIU0lH\n-----END SSH SIGNATURE-----\nbody",
        b"-----BEGIN SSH SIGNATURE-----\n" + b"A" * 30_000,
    ],
)
def test_what_is_no_signature_is_said(content):  # R-X16
    reason = parted(content)
    assert isinstance(reason, Reason) and reason.key == "store.signature_missing"


def test_without_anything_that_judges_nothing_is_believed(tmp_path, monkeypatch):  # R-X16
    signature, body = signed(tmp_path)
    monkeypatch.setitem(sys.modules, "cryptography", None)
    monkeypatch.setitem(sys.modules, "cryptography.exceptions", None)
    assert fault(signature, body, NO_PROGRAM).key == "store.no_signature_program"
    refused = sign(b"body", tmp_path / "key", NO_PROGRAM)
    assert isinstance(refused, Reason) and refused.key == "store.no_signing_program"


def test_the_package_cryptography_judges_where_there_is_no_ssh_keygen(tmp_path):  # R-X16
    pytest.importorskip("cryptography")
    signature, body = signed(tmp_path)
    assert not fault(signature, body, NO_PROGRAM)
    assert fault(signature, b"bodY", NO_PROGRAM).key == "store.signature_bad"
