from pathlib import Path

import pytest

from kit.runtime.process_sandbox import process_sandbox
from onika.runtime.error import LawBroken
from onika.runtime.sandbox.sandbox_messages import Call, encode

SOURCE = """
import os
from onika.module import Module

class Tried(Module):
    def get(self, name):
        if name == "forever":
            while True:
                pass
        if name == "end":
            os._exit(3)
        if name == "much":
            return "x" * (1 << 21)
        if name == "strange":
            return object()
        return name
"""


def test_it_answers_what_it_is_asked():  # R-X16
    with process_sandbox(SOURCE) as sandbox:
        assert sandbox.got("this").value == "this"
        assert not sandbox.end.is_heard


def test_who_does_not_come_back_in_time_is_ended():  # R-X16
    with process_sandbox(SOURCE) as sandbox:
        with pytest.raises(LawBroken, match="did not come back within"):
            sandbox.end.ask(encode(Call("get", 0.0, 0.01, 0, ("forever",))), 0.05)
        assert sandbox.end.is_heard
        with pytest.raises(LawBroken, match="has ended"):
            sandbox.got("this")


def test_who_ends_is_told():  # R-X16
    with process_sandbox(SOURCE) as sandbox, pytest.raises(LawBroken, match="has ended"):
        sandbox.got("end")


@pytest.mark.parametrize("name", ["much", "strange"])
def test_what_cannot_be_sent_is_said_and_the_sandbox_goes_on(name):  # R-X16
    with process_sandbox(SOURCE) as sandbox:
        assert sandbox.got(name).reason
        assert sandbox.got("this").value == "this"


def open_descriptors():
    return len(list(Path("/proc/self/fd").iterdir()))


def test_no_descriptor_is_left():
    before = open_descriptors()
    with process_sandbox(SOURCE) as sandbox:
        sandbox.end.close()
        sandbox.end.close()
    del sandbox
    assert open_descriptors() == before
