"""The certificate that a machine shows to whoever comes, before anybody trusts it (requirements F02, F03)."""

import hashlib
import socket
import ssl

from onika.link.address import bracketed
from onika.link.lost import LinkLost, LossCause
from onika.words.reason import Reason
from onika.words.system_error import system_reason

WITHIN_S = 5.0


def shown_certificate(host: str, port: int) -> bytes:
    """The certificate (DER), whoever has signed it; nothing is told there. Raises LinkLost."""
    anybody = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    anybody.check_hostname, anybody.verify_mode = False, ssl.CERT_NONE
    return _opened(host, port, anybody)


def unfit(host: str, port: int, certificate: bytes) -> Reason | None:
    """Why a certificate (DER) would not do for this host although it is trusted: another name, its time is over."""
    trusted = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    trusted.verify_flags |= ssl.VERIFY_X509_PARTIAL_CHAIN
    trusted.load_verify_locations(cadata=certificate)
    try:
        _opened(host, port, trusted)
    except LinkLost as lost:
        return lost.reason
    return None


def fingerprint_of(certificate: bytes) -> str:
    """The SHA-256 of a certificate (DER), as browsers show it."""
    return hashlib.sha256(certificate).digest().hex(":").upper()


def _opened(host: str, port: int, context: ssl.SSLContext) -> bytes:
    place = f"{bracketed(host)}:{port}"
    try:
        with (
            socket.create_connection((host, port), WITHIN_S) as plain,
            context.wrap_socket(plain, server_hostname=host) as private,
        ):
            return private.getpeercert(binary_form=True) or b""
    except ssl.SSLCertVerificationError as fault:
        why = Reason.plain(fault.verify_message)
        raise LinkLost(LossCause.CERTIFICATE, Reason.of("link.untrusted", address=place, why=why)) from None
    except ssl.SSLError as fault:
        why = Reason.plain(str(fault.reason))
        raise LinkLost(LossCause.CERTIFICATE, Reason.of("link.not_private", address=place, why=why)) from None
    except TimeoutError:
        raise LinkLost(LossCause.TIMEOUT, Reason.of("link.no_answer", address=place, seconds=WITHIN_S)) from None
    except OSError as fault:
        raise LinkLost(
            LossCause.UNREACHABLE, Reason.of("link.nobody", address=place, why=system_reason(fault))
        ) from None
