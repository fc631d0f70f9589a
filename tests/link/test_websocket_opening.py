import socket
import threading

import pytest

from onika.link import refusal_header
from onika.link.address import Address
from onika.link.channel import Channel
from onika.link.lost import LinkLost, LossCause
from onika.link.websocket_opening import WebSocketOpening
from onika.words.reason import Reason, in_language


class Door:
    """Answers one connection with these bytes and keeps what it was asked."""

    def __init__(self, answer):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = Address("127.0.0.1", self.listener.getsockname()[1], False)
        self.asked = b""
        self.thread = threading.Thread(target=self.serve, args=(answer,))
        self.thread.start()

    def serve(self, answer):
        connected, _ = self.listener.accept()
        with connected:
            self.asked = connected.recv(4096)
            connected.sendall(answer)

    def close(self):
        self.thread.join(5.0)
        self.listener.close()


@pytest.mark.parametrize(
    ("answer", "cause"),
    [
        (b"HTTP/1.1 401 Unauthorized\r\nContent-Length: 5\r\n\r\nwrong", LossCause.TOKEN),
        (b"HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\n\r\n", LossCause.FORBIDDEN),
        (b"HTTP/1.1 429 Too Many\r\nContent-Length: 0\r\n\r\n", LossCause.FORBIDDEN),
        (b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n", LossCause.REFUSED),
        (b"SSH-2.0-OpenSSH\r\n", LossCause.GARBAGE),
        (b"", LossCause.GARBAGE),
    ],
)
def test_each_refusal_has_its_own_cause(answer, cause):  # R-F01
    door = Door(answer)
    with pytest.raises(LinkLost) as lost:
        WebSocketOpening(door.address, "s3cret")(Channel.SIGNAL)
    door.close()
    assert lost.value.cause is cause
    assert "s3cret" not in str(lost.value)
    assert b"GET /signal HTTP/1.1" in door.asked
    assert b"Authorization: Bearer s3cret" in door.asked


def test_why_a_runtime_refuses_keeps_its_key_and_its_arguments():  # R-G03
    reason = Reason.of("host.no_such_path", paths=("/", "/signal"))
    head = f"HTTP/1.1 404 Not Found\r\nContent-Length: 3\r\n{refusal_header.HEADER}: {refusal_header.written(reason)}"
    door = Door(f"{head}\r\n\r\nno\n".encode())
    with pytest.raises(LinkLost) as lost:
        WebSocketOpening(door.address, "x")(Channel.SIGNAL)
    door.close()
    assert lost.value.reason.args["why"] == reason
    assert "se esperaba uno de /, /signal" in in_language(lost.value.reason, "es")


def test_a_refusal_of_a_foreign_program_is_told_as_it_came():
    door = Door(b"HTTP/1.1 403 No\r\nOnika-Reason: {}\r\nContent-Length: 7\r\n\r\nno way\n")
    with pytest.raises(LinkLost) as lost:
        WebSocketOpening(door.address, "x")(Channel.SIGNAL)
    door.close()
    assert lost.value.reason.args["why"] == Reason.plain("no way")


def test_where_nobody_listens_nobody_can_be_reached():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        port = listener.getsockname()[1]
    with pytest.raises(LinkLost) as lost:
        WebSocketOpening(Address("127.0.0.1", port, False), "x")(Channel.ALL)
    assert lost.value.cause is LossCause.UNREACHABLE


def test_one_who_speaks_no_tls_is_not_trusted():
    door = Door(b"HTTP/1.1 400 Bad\r\n\r\n")
    with pytest.raises(LinkLost) as lost:
        WebSocketOpening(Address("127.0.0.1", door.address.port, True), "s3cret")(Channel.ALL)
    door.close()
    assert lost.value.cause is LossCause.CERTIFICATE
    assert b"s3cret" not in door.asked


def test_a_file_without_certificates_is_told(tmp_path):
    (tmp_path / "ca").write_text("nothing")
    door = Door(b"")
    with pytest.raises(LinkLost, match="holds no certificates"):
        WebSocketOpening(Address("127.0.0.1", door.address.port, True), "x", tmp_path / "ca")(Channel.ALL)
    door.close()
