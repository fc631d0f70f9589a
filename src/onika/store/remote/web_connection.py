"""One connection to a server, which answers one question after the other within limits."""

import http.client
import socket
import ssl
import time
from collections.abc import Callable
from contextlib import suppress
from threading import Timer
from typing import TypeVar

from onika.files.state.kept_certificates import is_own, trusting_kept
from onika.store.remote.address import WebAddress
from onika.store.remote.credential import Credential
from onika.store.remote.limits import Limits
from onika.store.remote.piece import Piece, Span, size_of_whole
from onika.store.remote.source import Wanted
from onika.words.reason import Reason
from onika.words.system_error import system_reason

_T = TypeVar("_T")
_CHUNK = 65536
_JSON = "application/json"
_PARTIAL = 206
_MOVED = (301, 302, 303, 307, 308)


class WebConnection:
    """Of one thread at a time. An answer, or its refusal, comes within the limits; only finding a host's name may
    take longer.
    """

    def __init__(self, address: WebAddress, limits: Limits, credential: Credential | None) -> None:
        self._address = address
        self._limits = limits
        self._credential = credential
        self._connection: http.client.HTTPConnection | None = None
        self._socket: socket.socket | None = None
        self._is_late = False
        self._is_over = False

    def open(self) -> None:
        """Connect ahead of the first question; where that is not possible, the question will tell."""
        self._guarded("", self._connected)

    def get(self, wanted: Wanted) -> bytes | Reason:
        """A file; over a connection that the server has closed meanwhile it is asked for once more."""
        return self._again_where_gone(wanted.path, lambda: self._asked(wanted))

    def piece(self, wanted: Wanted, span: Span) -> Piece | Reason:
        """Some bytes of a file, asked for as a whole file is; all of them from a server that knows no pieces."""
        return self._again_where_gone(wanted.path, lambda: self._piece(wanted, span))

    @property
    def is_open(self) -> bool:
        """Whether a question need not wait for a connection."""
        return self._connection is not None

    def post(self, path: str, body: bytes, most: int) -> bytes | Reason:
        """Send something once; what is answered in JSON, whatever its status. It is never sent on elsewhere."""
        return self._guarded(path, lambda: self._posted(path, body, most))

    def end(self) -> None:
        """Close it for good, also where another thread is just opening it."""
        self._is_over = True
        self.close()

    def close(self) -> None:
        """Close it; another thread may do so too. The next question opens it again."""
        ours = self._socket
        if ours is not None:
            with suppress(OSError):
                socket.socket.shutdown(ours, socket.SHUT_RDWR)  # not the farewell of TLS, which would wait
        connection, self._connection, self._socket = self._connection, None, None
        if ours is not None:
            ours.close()
        if connection is not None:
            connection.close()

    def _again_where_gone(self, path: str, do: Callable[[], _T | Reason]) -> _T | Reason:
        was_open = self.is_open
        answer = self._guarded(path, do)
        if isinstance(answer, Reason) and was_open and answer.key == "store.server_gone":
            return self._guarded(path, do)
        return answer

    def _guarded(self, path: str, do: Callable[[], _T | Reason]) -> _T | Reason:
        """What is done, or why not, at the latest when the time is over."""
        self._is_late = False
        watchdog = Timer(self._limits.total_s, self._expire)
        watchdog.daemon = True
        watchdog.start()
        try:
            answer = do()
        except (OSError, http.client.HTTPException, ValueError) as error:
            self.close()
            return self._reason(path, error)
        finally:
            watchdog.cancel()
        if isinstance(answer, Reason):
            self.close()
        return answer

    def _expire(self) -> None:
        self._is_late = True
        ours = self._socket
        if ours is not None:
            with suppress(OSError):
                socket.socket.shutdown(ours, socket.SHUT_RDWR)

    def _connected(self) -> http.client.HTTPConnection:
        if self._connection is not None:
            return self._connection
        host, port = self._address.host, self._address.port
        plain = socket.create_connection((host, port), timeout=self._limits.connect_s)
        self._socket = plain
        plain.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        ours = plain
        if self._address.is_tls:
            ours = trusting_kept(host).wrap_socket(plain, server_hostname=host)
        ours.settimeout(self._limits.idle_s)
        connection = http.client.HTTPConnection(host, port)
        connection.sock = ours
        self._connection, self._socket = connection, ours
        if self._is_over:
            raise ConnectionResetError
        return connection

    def _asked(self, wanted: Wanted) -> bytes | Reason:
        response = self._found(wanted)
        if isinstance(response, Reason):
            return response
        return self._answer(response, wanted)

    def _piece(self, wanted: Wanted, span: Span) -> Piece | Reason:
        response = self._found(wanted, span)
        if isinstance(response, Reason):
            return response
        mark = response.headers.get("ETag", "") or response.headers.get("Last-Modified", "")
        if response.status != _PARTIAL:
            content = self._answer(response, wanted)
            if isinstance(content, Reason):
                return content
            return Piece(content, len(content), mark)
        size = size_of_whole(span, response.headers.get("Content-Range", ""))
        if size is None:
            return Reason.of("store.server_garbled", host=self._address.host)
        if size > wanted.most:
            return Reason.of("store.answer_large", path=wanted.path, most=wanted.most)
        content = self._body(response, Wanted(wanted.path, min(span.end, size) - span.begin))
        if isinstance(content, Reason):
            return content
        return Piece(content, size, mark)

    def _found(self, wanted: Wanted, span: Span | None = None) -> http.client.HTTPResponse | Reason:
        """The answer of the place to which the server sends us in the end."""
        target = self._address.below(wanted.path)
        for _ in range(self._limits.redirects + 1):
            response = self._response(target, span=span)
            if response.status not in _MOVED:
                return response
            self._body(response, Wanted(wanted.path, _CHUNK))
            moved = self._address.redirected(target, response.headers.get("Location", ""))
            if isinstance(moved, Reason):
                return moved
            target = moved
        return Reason.of("store.sent_around", host=self._address.host)

    def _posted(self, path: str, body: bytes, most: int) -> bytes | Reason:
        if not self._address.keeps_secrets:
            return Reason.of("store.change_unsafe", host=self._address.host)
        response = self._response(self._address.below(path), body)
        wanted = Wanted(path, most)
        if response.headers.get("Content-Type", "") == _JSON:
            return self._body(response, wanted)
        answer = self._answer(response, wanted)
        if isinstance(answer, Reason) and answer.key not in ("store.not_on_server", "store.server_answer"):
            return answer
        return Reason.of("store.takes_no_changes", host=self._address.host, status=response.status)

    def _response(self, target: str, body: bytes | None = None, span: Span | None = None) -> http.client.HTTPResponse:
        connection = self._connected()
        connection.putrequest("GET" if body is None else "POST", target, skip_host=True, skip_accept_encoding=True)
        connection.putheader("Host", self._address.authority)
        connection.putheader("Accept-Encoding", "identity")
        connection.putheader("User-Agent", "onika")
        if self._credential is not None and self._address.keeps_secrets:
            connection.putheader("Authorization", self._credential.header)
        if span is not None:
            connection.putheader("Range", span.header)
        if body is not None:
            connection.putheader("Content-Type", _JSON)
            connection.putheader("Content-Length", str(len(body)))
        connection.endheaders(body)
        return connection.getresponse()

    def _answer(self, response: http.client.HTTPResponse, wanted: Wanted) -> bytes | Reason:
        host = self._address.host
        match response.status:
            case 200:
                return self._body(response, wanted)
            case 401 if not self._address.keeps_secrets:
                return Reason.of("store.password_unsafe", host=host)
            case 401 if self._credential is not None:
                return Reason.of("store.password_wrong", host=host)
            case 401:
                return Reason.of("store.password_needed", host=host)
            case 403:
                return Reason.of("store.not_let_in", host=host)
            case 404 | 410:
                return Reason.of("store.not_on_server", host=host, path=wanted.path)
        return Reason.of("store.server_answer", host=host, status=response.status)

    def _body(self, response: http.client.HTTPResponse, wanted: Wanted) -> bytes | Reason:
        """What is answered; refused as soon as it is too much or too slow."""
        limits = self._limits
        if response.length is not None and response.length > wanted.most:
            return Reason.of("store.answer_large", path=wanted.path, most=wanted.most)
        begin, parts, count = time.monotonic(), list[bytes](), 0
        while part := response.read1(_CHUNK):
            parts.append(part)
            count += len(part)
            if count > wanted.most:
                return Reason.of("store.answer_large", path=wanted.path, most=wanted.most)
            lasted_s = time.monotonic() - begin
            if lasted_s > limits.grace_s and count < limits.rate * lasted_s:
                return Reason.of("store.server_slow", host=self._address.host)
        if self._is_late:
            return Reason.of("store.server_slow", host=self._address.host)
        if response.length:
            return Reason.of("store.answer_cut", host=self._address.host, path=wanted.path)
        response.close()  # what was read to its end part by part does not notice that itself
        if response.will_close:
            self.close()
        return b"".join(parts)

    def _reason(self, path: str, error: Exception) -> Reason:
        """Why a question has no answer."""
        host = self._address.host
        match error:
            case _ if self._is_late:
                return Reason.of("store.server_slow", host=host)
            case ssl.SSLCertVerificationError() if is_own(error):
                why, place = Reason.plain(error.verify_message), f"{host}:{self._address.port}"
                return Reason.of("store.certificate_own", host=host, why=why, place=place)
            case ssl.SSLCertVerificationError():
                return Reason.of("store.certificate", host=host, why=Reason.plain(error.verify_message))
            case http.client.IncompleteRead():
                return Reason.of("store.answer_cut", host=host, path=path)
            case http.client.RemoteDisconnected() | ConnectionResetError() | BrokenPipeError():
                return Reason.of("store.server_gone", host=host)
            case socket.gaierror():
                return Reason.of("store.host_unknown", host=host)
            case TimeoutError():
                return Reason.of("store.server_silent", host=host)
            case ssl.SSLError() | http.client.HTTPException() | ValueError():
                return Reason.of("store.server_garbled", host=host)
            case OSError():
                return Reason.of("store.server_unreached", host=host, why=system_reason(error))
        return Reason.of("store.server_garbled", host=host)
