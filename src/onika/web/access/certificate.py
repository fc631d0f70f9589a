"""The certificate of a server: its context of TLS, its names, and the fingerprint by which people know it."""

import hashlib
import ssl
from contextlib import suppress
from pathlib import Path


def server_context(certificate: str, key: str) -> ssl.SSLContext:
    """The server's side of TLS 1.2 or newer; raises OSError or ssl.SSLError for files that are none."""
    made = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    made.minimum_version = ssl.TLSVersion.TLSv1_2
    made.load_cert_chain(certificate, key)
    return made


def is_for(context: ssl.SSLContext, certificate: str, name: str) -> bool:
    """Whether a browser that trusts this certificate takes a server of this name for it; it is tried in memory."""
    browser = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    browser.verify_flags |= ssl.VERIFY_X509_PARTIAL_CHAIN  # the certificate itself is trusted, whoever signed it
    try:
        browser.load_verify_locations(certificate)
        _shake_hands(browser, context, name)
    except (OSError, ValueError):  # an SSLError is an OSError
        return False
    return True


def _shake_hands(browser: ssl.SSLContext, server: ssl.SSLContext, name: str) -> None:
    """One handshake of both; raises ssl.SSLError where the browser goes away."""
    asked, answered = ssl.MemoryBIO(), ssl.MemoryBIO()
    client = browser.wrap_bio(answered, asked, server_hostname=name)
    other = server.wrap_bio(asked, answered, server_side=True)
    for side in (client, other, client):  # the hello, the certificate, and what the browser thinks of it
        with suppress(ssl.SSLWantReadError):
            side.do_handshake()


def fingerprint(certificate: str) -> str:
    """The SHA-256 of the first certificate in a PEM file, as browsers show it; raises OSError or ValueError."""
    text = Path(certificate).read_text(encoding="ascii", errors="replace")
    begin, end = "-----BEGIN CERTIFICATE-----", "-----END CERTIFICATE-----"
    first = text[text.index(begin) : text.index(end) + len(end)]
    return hashlib.sha256(ssl.PEM_cert_to_DER_cert(first)).digest().hex(":").upper()
