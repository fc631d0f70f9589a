"""The process that renders, as far as it goes without graphics."""

import socket

from kit.worlds.filmed_cells import filmed
from onika.workcell.filmed.camera_messages import Exposure, Film, decode_exposed, encode, laid_out, room_of
from onika.workcell.filmed.camera_process import serve

EYES = laid_out([("camera.above", (48, 64))])


def test_what_keeps_it_from_drawing_is_the_answer_to_every_order(monkeypatch):  # R-F05
    monkeypatch.setattr("onika.workcell.filmed.camera_process.RenderedWorld", None)
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    for number in (3, 4):
        ours.send(encode(Exposure(0, number, {}, b"", ())))
    ours.shutdown(socket.SHUT_WR)
    serve(theirs, Film(filmed(), EYES), memoryview(bytearray(room_of(EYES))))
    answers = [decode_exposed(ours.recv(1 << 16)) for _ in range(2)]
    ours.close()
    theirs.close()
    assert [answer.taken_ns for answer in answers] == [3, 4]
    assert all("not callable" in str(answer.why) for answer in answers)
