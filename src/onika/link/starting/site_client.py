"""What is asked of a site over HTTP: its card, to launch something that it has listed, to end it (requirement A15).

Every question has an end: whatever the site says, or does not say, it is over after so many seconds.
"""

import http.client
import socket
import ssl
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from threading import Timer
from typing import TypeVar

from msgspec import DecodeError, ValidationError, json

from onika.link import refusal_header
from onika.link.lost import LinkLost, LossCause
from onika.link.starting.site_address import SiteAddress
from onika.link.trust import trusting, untrusted
from onika.wire.site_card import SiteCard, SiteHandOver
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

CONNECT_S = 1.5
ANSWER_S = 10.0
LAUNCH_S = 40.0
"""How long it may take until a runtime is there, or it is known why not."""
_LARGEST = 1 << 20
_CAUSES = {
    401: LossCause.TOKEN,
    403: LossCause.FORBIDDEN,
    429: LossCause.FORBIDDEN,
}
_T = TypeVar("_T")


class SiteClient:
    """Asks one site; everything raises LinkLost with the reason."""

    def __init__(self, address: SiteAddress, token: str, authority: Path | None = None) -> None:
        self._address = address
        self._token = token
        self._authority = authority

    def card(self) -> SiteCard:
        """What the site says of itself."""
        return self._said("GET", "/card", SiteCard, ANSWER_S)

    def launch(self) -> SiteHandOver:
        """Have the runtime of the address's name run, and be handed it over."""
        way = "?stay" if self._address.stays else ""
        return self._said("POST", f"/launch/{self._address.name}{way}", SiteHandOver, LAUNCH_S)

    def end(self) -> None:
        """End the runtime of that name."""
        self._body("POST", f"/end/{self._address.name}", LAUNCH_S)

    # Inner

    def _said(self, method: str, path: str, kind: type[_T], within_s: float) -> _T:
        body = self._body(method, path, within_s)
        try:
            return json.decode(body, type=kind)
        except (DecodeError, ValidationError, RecursionError):
            raise LinkLost(LossCause.GARBAGE, Reason.of("link.no_site", site=self._where)) from None

    @property
    def _where(self) -> str:
        return str(SiteAddress(self._address.host, self._address.port, is_private=self._address.is_private))

    def _body(self, method: str, path: str, within_s: float) -> bytes:
        """What is answered, within the time."""
        connection = self._connected()
        ours, is_late = connection.sock, [False]

        def expire() -> None:
            is_late[0] = True
            with suppress(OSError):
                socket.socket.shutdown(ours, socket.SHUT_RDWR)  # not the farewell of TLS, which would wait

        watchdog = Timer(within_s, expire)
        watchdog.daemon = True
        watchdog.start()
        try:
            answer = self._answered(connection, method, path)
        except (OSError, http.client.HTTPException) as fault:
            if is_late[0]:
                late = Reason.of("link.site_late", site=self._where, seconds=within_s)
                raise LinkLost(LossCause.TIMEOUT, late) from None
            why = system_reason(fault) if isinstance(fault, OSError) else NOTHING
            ended = Reason.of("link.opening_ended", address=self._where, why=why or Reason.of("link.no_http"))
            raise LinkLost(LossCause.UNREACHABLE, ended) from None
        finally:
            watchdog.cancel()
            connection.close()
        if isinstance(answer, LinkLost):
            raise answer
        return answer

    def _answered(self, connection: http.client.HTTPConnection, method: str, path: str) -> bytes | LinkLost:
        headers = {"Authorization": f"Bearer {self._token}", "Host": self._address.place, "Connection": "close"}
        connection.request(method, path, headers=headers)
        response = connection.getresponse()
        body = response.read(_LARGEST + 1)
        if len(body) > _LARGEST:
            return LinkLost(LossCause.GARBAGE, Reason.of("link.no_site", site=self._where))
        if response.status < 300:
            return body
        why = refusal_header.read(response.headers.get(refusal_header.HEADER, ""))
        cause = _CAUSES.get(response.status, LossCause.REFUSED)
        if why is None:
            why = Reason.of("link.no_site", site=self._where)
        return LinkLost(cause, Reason.of("link.site_refused", site=self._where, why=why))

    def _connected(self) -> http.client.HTTPConnection:
        host, port = self._address.host, self._address.port
        made: Callable[[], socket.socket] = self._private if self._address.is_private else self._plain
        connection = http.client.HTTPConnection(host, port)
        try:
            connection.sock = made()
        except ssl.SSLCertVerificationError as fault:
            raise untrusted(fault, self._where, self._address.place) from None
        except ssl.SSLError as fault:
            why = Reason.plain(str(fault.reason))
            raise LinkLost(LossCause.CERTIFICATE, Reason.of("link.not_private", address=self._where, why=why)) from None
        except TimeoutError:
            silent = Reason.of("link.no_answer", address=self._where, seconds=CONNECT_S)
            raise LinkLost(LossCause.TIMEOUT, silent) from None
        except OSError as fault:
            nobody = Reason.of("link.no_site_there", site=self._where, why=system_reason(fault))
            raise LinkLost(LossCause.UNREACHABLE, nobody) from None
        return connection

    def _plain(self) -> socket.socket:
        connected = socket.create_connection((self._address.host, self._address.port), CONNECT_S)
        connected.settimeout(LAUNCH_S)
        return connected

    def _private(self) -> socket.socket:
        context = trusting(self._authority, self._address.host)
        plain = socket.create_connection((self._address.host, self._address.port), CONNECT_S)
        try:
            plain.settimeout(ANSWER_S)
            private = context.wrap_socket(plain, server_hostname=self._address.host)
        except BaseException:
            plain.close()
            raise
        private.settimeout(LAUNCH_S)
        return private
