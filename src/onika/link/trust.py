"""Whose certificates are trusted where a runtime or a site is reached over TLS."""

import ssl
from pathlib import Path

from onika.files.state.kept_certificates import is_own, trusting_kept
from onika.link.lost import LinkLost, LossCause
from onika.words.reason import Reason


def trusting(authority: Path | None, host: str) -> ssl.SSLContext:
    """TLS 1.2 or newer with the certificates of the system, what is kept for the host, and those of a file beside them.

    Raises LinkLost.
    """
    context = trusting_kept(host)
    if authority is not None:
        try:
            context.load_verify_locations(authority)
        except (OSError, ssl.SSLError) as fault:
            why = Reason.plain(str(fault))
            raise LinkLost(
                LossCause.CERTIFICATE, Reason.of("link.no_certificates", path=str(authority), why=why)
            ) from None
    return context


def untrusted(fault: ssl.SSLCertVerificationError, address: str, place: str) -> LinkLost:
    """Why a certificate is not trusted; how one can be that its machine has made itself, at `place`, its HOST:PORT."""
    why = Reason.plain(fault.verify_message)
    if is_own(fault):
        return LinkLost(LossCause.CERTIFICATE, Reason.of("link.untrusted_own", address=address, why=why, place=place))
    return LinkLost(LossCause.CERTIFICATE, Reason.of("link.untrusted", address=address, why=why))
