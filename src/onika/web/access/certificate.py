"""The certificate of a server: the context of TLS made of it, and the fingerprint by which people know it again."""

import hashlib
import ssl
from pathlib import Path


def server_context(certificate: str, key: str) -> ssl.SSLContext:
    """The server's side of TLS 1.2 or newer; raises OSError or ssl.SSLError for files that are none."""
    made = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    made.minimum_version = ssl.TLSVersion.TLSv1_2
    made.load_cert_chain(certificate, key)
    return made


def fingerprint(certificate: str) -> str:
    """The SHA-256 of the first certificate in a PEM file, as browsers show it; raises OSError or ValueError."""
    text = Path(certificate).read_text(encoding="ascii", errors="replace")
    begin, end = "-----BEGIN CERTIFICATE-----", "-----END CERTIFICATE-----"
    first = text[text.index(begin) : text.index(end) + len(end)]
    return hashlib.sha256(ssl.PEM_cert_to_DER_cert(first)).digest().hex(":").upper()
