"""The certificates that a user trusts for one host each: of machines that have made their own (requirements F02, F03).

They are trusted beside those of the system, for that host alone, whatever else they might sign.
"""

import os
import ssl
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from onika.files.state.state_directory import make_own, state_directory

_ENDING = ".pem"
_UNKNOWN = (18, 19, 20, 21)
"""What OpenSSL says where nobody it knows has signed: X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT and its kin."""


def certificate_path(host: str, environment: Mapping[str, str] = os.environ) -> Path:
    """Where the certificate of a host is kept, or would be."""
    letters = "".join(letter if letter.isalnum() or letter in "-." else "_" for letter in host.casefold())
    return state_directory(environment) / "certificates" / f"{letters.lstrip('.')}{_ENDING}"


def trusting_kept(host: str, environment: Mapping[str, str] = os.environ) -> ssl.SSLContext:
    """TLS 1.2 or newer with the certificates of the system, and that which is kept for the host.

    What is kept and cannot be read counts as nothing: less is trusted then, not more.
    """
    context = ssl.create_default_context()
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    path = certificate_path(host, environment)
    if path.is_file():
        with suppress(OSError, ssl.SSLError):
            context.load_verify_locations(path)
            context.verify_flags |= ssl.VERIFY_X509_PARTIAL_CHAIN  # it is trusted itself, whoever has signed it
    return context


def is_own(fault: ssl.SSLCertVerificationError) -> bool:
    """Whether a certificate is not trusted because nobody has signed it who is known here: it could be kept."""
    return fault.verify_code in _UNKNOWN


def keep_certificate(host: str, certificate: bytes, environment: Mapping[str, str] = os.environ) -> Path:
    """Trust a certificate (DER) for a host from now on, in place of a former one; raises OSError."""
    path = certificate_path(host, environment)
    make_own(path.parent)
    descriptor, draft = tempfile.mkstemp(dir=path.parent, prefix=".draft.")
    try:
        with os.fdopen(descriptor, "w", encoding="ascii") as file:
            file.write(ssl.DER_cert_to_PEM_cert(certificate))
        Path(draft).replace(path)
    except BaseException:
        with suppress(OSError):
            Path(draft).unlink()
        raise
    return path
