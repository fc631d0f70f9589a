"""What a world and the process that renders for it say to each other."""

from onika.workcell.filmed.camera_messages import Exposure, decode_exposure, encode, laid_out, room_of


def test_pictures_lie_one_behind_the_other():  # R-F08
    eyes = laid_out([("a", (240, 320)), ("b", (16, 16))])
    assert [(eye.name, eye.width, eye.height) for eye in eyes] == [("a", 320, 240), ("b", 16, 16)]
    assert eyes[0].offset == 0
    assert eyes[1].offset >= 3 * 320 * 240
    assert room_of(eyes) == eyes[1].offset + 768
    assert room_of(()) > 0


def test_what_is_asked_is_what_is_read():
    exposure = Exposure(1, 5, {"left": "elbow"}, b"12345678", ("bulb",), True)
    assert decode_exposure(encode(exposure)) == exposure
