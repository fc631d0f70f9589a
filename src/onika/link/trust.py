"""Whose certificates are trusted where a runtime or a site is reached over TLS."""

import ssl
from pathlib import Path

from onika.link.lost import LinkLost, LossCause
from onika.words.reason import Reason


def trusting(authority: Path | None) -> ssl.SSLContext:
    """TLS 1.2 or newer with the certificates of the system, and those of a file beside them; raises LinkLost."""
    context = ssl.create_default_context()
    context.minimum_version = ssl.TLSVersion.TLSv1_2
    if authority is not None:
        try:
            context.load_verify_locations(authority)
        except (OSError, ssl.SSLError) as fault:
            why = Reason.plain(str(fault))
            raise LinkLost(
                LossCause.CERTIFICATE, Reason.of("link.no_certificates", path=str(authority), why=why)
            ) from None
    return context
