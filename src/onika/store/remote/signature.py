"""A signature as `ssh-keygen -Y sign` makes it, of a library or a site's card: whose it is, whether it is good (X16).

Keys are those that people have for ssh. Nothing is signed or judged by ciphers of our own: `ssh-keygen` does it, or,
where there is none, the package `cryptography`, which here judges Ed25519 only; without either nothing is believed.
"""

import base64
import binascii
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import new as new_hash, sha256
from pathlib import Path

from onika.words.reason import NOTHING, Reason, reason_of

NAMESPACE = "onika-library"
"""What is signed where nothing else is said: a signature for anything else is none for a library."""

PROGRAM = "ssh-keygen"
_BEGIN, _END = b"-----BEGIN SSH SIGNATURE-----\n", b"\n-----END SSH SIGNATURE-----\n"
_MAGIC = b"SSHSIG"
_MOST = 20_000
"""Bytes of a signature; one of a key of 16,384 bits has 6,000."""
_PATIENCE_S = 20.0
_KIND = re.compile(rb"[A-Za-z0-9@.-]{1,64}\Z")
_HASHES = ("sha256", "sha512")
_ED25519 = b"ssh-ed25519"


@dataclass(frozen=True, slots=True)
class Signature:
    """A signature as text, and what stands in it; that it is good is not said by that."""

    text: bytes
    key: bytes
    """The public key, as ssh writes it."""
    namespace: str
    hash_name: str
    signed: bytes
    """The signature itself, behind the name of its kind."""

    @property
    def fingerprint(self) -> str:
        """The fingerprint of the key, as `ssh-keygen -l` writes it."""
        return "SHA256:" + base64.b64encode(sha256(self.key).digest()).decode().rstrip("=")


def parted(content: bytes) -> tuple[Signature, bytes] | Reason:
    """The signature at the head of signed bytes, and what is signed; a reason where there is none."""
    end = content.find(_END, 0, _MOST)
    if not content.startswith(_BEGIN) or end < 0:
        return Reason.of("store.signature_missing")
    behind = end + len(_END)
    try:
        blob = base64.b64decode(content[len(_BEGIN) : end].replace(b"\n", b""), validate=True)
        return _parsed(content[:behind], blob), content[behind:]
    except (ValueError, binascii.Error):
        return Reason.of("store.signature_missing")


def fault(signature: Signature, body: bytes, program: str = PROGRAM, namespace: str = NAMESPACE) -> Reason:
    """Why a signature is none of `body` by its key; NOTHING where it is good."""
    if signature.namespace != namespace:
        return Reason.of("store.signature_of_other", namespace=repr(signature.namespace[:40]))
    path = shutil.which(program)
    if path is not None:
        return _fault_by_program(signature, body, path)
    judge = _ed25519_judge()
    if judge is None:
        return Reason.of("store.no_signature_program")
    return judge(signature, body)


def sign(body: bytes, key: Path, program: str = PROGRAM, namespace: str = NAMESPACE) -> bytes | Reason:
    """`body` behind its signature by the key in a file; `ssh-keygen` asks for its pass phrase, or an agent, itself."""
    path = shutil.which(program)
    if path is None:
        return Reason.of("store.no_signing_program")
    words = [path, "-q", "-Y", "sign", "-f", str(key), "-n", namespace]
    signed = subprocess.run(words, input=body, capture_output=True, check=False)  # noqa: S603 - no shell; a path
    if signed.returncode != 0:
        return Reason.of("store.not_signed", why=_last_line(signed.stderr))
    return signed.stdout + body


def _fault_by_program(signature: Signature, body: bytes, path: str) -> Reason:
    kind = _kind(signature.key)
    if kind is None:
        return Reason.of("store.signature_bad")
    namespace = signature.namespace.encode()
    signers = b'library namespaces="%s" %s %s\n' % (namespace, kind, base64.b64encode(signature.key))
    with tempfile.TemporaryDirectory(prefix="onika-") as folder:
        (Path(folder) / "signers").write_bytes(signers)
        (Path(folder) / "signature").write_bytes(signature.text)
        words = [path, "-q", "-Y", "verify", "-f", f"{folder}/signers", "-I", "library", "-n", signature.namespace]
        words += ["-s", f"{folder}/signature"]
        try:
            done = subprocess.run(words, input=body, capture_output=True, check=False, timeout=_PATIENCE_S)  # noqa: S603
        except subprocess.TimeoutExpired:
            return Reason.of("store.signature_bad")
    return NOTHING if done.returncode == 0 else Reason.of("store.signature_bad")


def _ed25519_judge() -> Callable[[Signature, bytes], Reason] | None:
    """What judges where there is no `ssh-keygen`; None where `cryptography` is not installed either."""
    try:
        from cryptography.exceptions import InvalidSignature
        from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey
    except ImportError:
        return None

    def judge(signature: Signature, body: bytes) -> Reason:
        try:
            kind, rest = _string(signature.key)
            number, _ = _string(rest)
            _, rest = _string(signature.signed)
            signed, _ = _string(rest)
            if kind != _ED25519:
                return Reason.of("store.signature_kind", kind=kind.decode("ascii", "replace")[:40])
            Ed25519PublicKey.from_public_bytes(number).verify(signed, _message(signature, body))
        except (ValueError, InvalidSignature):
            return Reason.of("store.signature_bad")
        return NOTHING

    return judge


def _message(signature: Signature, body: bytes) -> bytes:
    """What a key signs of a body."""
    digest = new_hash(signature.hash_name, body).digest()
    parts = (signature.namespace.encode(), b"", signature.hash_name.encode(), digest)
    return _MAGIC + b"".join(len(part).to_bytes(4) + part for part in parts)


def _parsed(text: bytes, blob: bytes) -> Signature:
    """The parts of a signature; raises ValueError where it is none."""
    if not blob.startswith(_MAGIC + (1).to_bytes(4)):
        raise ValueError
    key, rest = _string(blob[len(_MAGIC) + 4 :])
    namespace, rest = _string(rest)
    _, rest = _string(rest)
    hash_name, rest = _string(rest)
    signed, rest = _string(rest)
    if rest or hash_name.decode("ascii") not in _HASHES:
        raise ValueError
    return Signature(text, key, namespace.decode("utf-8"), hash_name.decode("ascii"), signed)


def _string(blob: bytes) -> tuple[bytes, bytes]:
    """The first string of bytes as ssh packs them, and what follows; raises ValueError."""
    size = int.from_bytes(blob[:4])
    if len(blob) < 4 + size:
        raise ValueError
    return blob[4 : 4 + size], blob[4 + size :]


def _kind(key: bytes) -> bytes | None:
    try:
        kind, _ = _string(key)
    except ValueError:
        return None
    return kind if _KIND.match(kind) else None


def _last_line(output: bytes) -> Reason:
    lines = output.decode("utf-8", "replace").strip().splitlines()
    return reason_of(ValueError(lines[-1] if lines else PROGRAM))
