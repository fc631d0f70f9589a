import logging

import pytest
from websockets.frames import Frame, Opcode
from websockets.http11 import Request

from onika.link.websocket_messages import SILENT, WebSocketMessages


def test_a_message_in_fragments_is_put_together():
    messages = WebSocketMessages()
    assert messages.feed([Frame(Opcode.BINARY, b"ab", fin=False)]) == []
    assert messages.feed([Frame(Opcode.PING, b"?"), Frame(Opcode.CONT, b"c", fin=False)]) == []
    assert messages.feed([Frame(Opcode.CONT, b"d"), Frame(Opcode.BINARY, b"e")]) == [b"abcd", b"e"]


def test_what_is_no_message_is_left_out():
    assert WebSocketMessages().feed([Request("/", None), Frame(Opcode.CLOSE, b""), Frame(Opcode.PONG, b"")]) == []


def test_a_text_is_refused():
    with pytest.raises(ValueError, match="found a text"):
        WebSocketMessages().feed([Frame(Opcode.TEXT, b"hello")])


def test_headers_are_never_logged():
    assert not SILENT.isEnabledFor(logging.CRITICAL)


def test_nothing_that_sets_up_logging_lets_headers_be_logged():
    assert SILENT.name not in logging.root.manager.loggerDict
