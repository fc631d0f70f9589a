import pytest
from msgspec import structs

from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.runtime.local_sandbox import LocalSandbox, sandboxed
from onika.runtime import command, news
from onika.runtime.sandbox.sandbox_messages import Declared, Returned, encode
from onika.wire.sheet import ModuleSheet

SOURCE = """
from onika.module import AskAgain, InVar, Input, Local, Module, ModuleError, OutBoth, OutVar, finish

class Scale(Module):
    trigger = True
    X = InVar("double[3]", "rad", "what is scaled")
    Y = OutVar("double[3]", "rad", "scaled")
    N = OutVar("int", "-", "cycles")
    T = OutBoth("string", "-", "a text")
    GAIN = Local("double", "-", "by how much", default=2.0)
    count = Input("int", "-", "how many cycles", low=0)

    def init(self):
        self.T = "began"
        self._left = 0

    def on(self, inputs):
        if inputs.count == 13:
            raise AskAgain("not {number}", number=13)
        self._left = inputs.count

    def cycle(self):
        self.Y = self.GAIN * self.X
        self.N += 1
        if self.N == 3:
            self.warn("three")
        if self.N == 66:
            return 1 / 0
        if self.N == 77:
            raise ModuleError("beyond {most}", most=76)
        self._left -= 1
        return finish() if not self._left else None

    def error(self, fault):
        return "beyond" in str(fault)

    def get(self, name):
        return {"left": self._left}[name]

    def set(self, name, value):
        self._left = int(value)
"""


_PERIOD = 10_000_000


class Rig:
    """A task in a sandbox on an executive."""

    def __init__(self, source=SOURCE, answers=None, **given):
        self.until = 0
        self.rig = ExecutiveRig()
        self.spawn = sandboxed(self.rig.spawn_of("scale", source, **given))
        self.sandbox = LocalSandbox(self.spawn, answers)
        self.give(self.sandbox)
        self.rig.do(self.spawn)

    def give(self, sandbox):
        self.rig.executive.give_sandbox((HOME, "scale"), sandbox)

    def on(self, count):
        self.rig.switch(on=[command.Launch("scale", count)])
        return self

    def run(self, cycles):
        self.until += cycles * _PERIOD
        self.rig.run(self.until - 1)
        return self


def test_it_does_what_it_does_without_a_sandbox():  # R-X16
    rig = Rig(local=[("GAIN", ("3",))])
    rig.rig.table.ring("X").write(memoryview(bytes(24)))
    assert rig.rig["T"] == "began"
    rig.on("5").run(10)
    assert rig.rig["N"] == 5
    assert [said.text for said in rig.rig.news_of(news.Warned)] == ["three"]
    assert len(rig.rig.news_of(news.Finished)) == 1


def test_values_go_there_and_come_back():
    rig = Rig(local=[("GAIN", ("3",))])
    rig.rig.spawn("feed", FEED).switch(on=["feed"])
    rig.on("5").run(6)
    assert rig.rig["Y"].tolist() == [3.0, 6.0, 9.0]


FEED = """
from onika.module import Module, OutVar

class Feed(Module):
    X = OutVar("double[3]", "rad", "what is scaled")

    def cycle(self):
        self.X = [1.0, 2.0, 3.0]
"""


def test_input_that_cannot_be_used_is_asked_for_again():
    rig = Rig().on("13")
    assert "not 13" in str(rig.rig.last(news.Asked).reason)


def test_what_is_raised_there_is_told_with_the_line_of_the_module():  # R-A09
    rig = Rig().on("70").run(70)
    failed = rig.rig.last(news.Failed)
    assert failed.text == "ZeroDivisionError: division by zero"
    assert (failed.path, failed.line) == ("scale.py", 1 + SOURCE[: SOURCE.index("1 / 0")].count("\n"))
    assert "1 / 0" in failed.traceback or "cycle" in failed.traceback


def test_the_error_entry_is_asked_there():
    rig = Rig(SOURCE.replace("return 1 / 0", "pass")).on("80").run(85)
    assert rig.rig.news_of(news.Failed) == []
    assert rig.rig["N"] == 81


def test_values_are_got_and_set():
    rig = Rig().on("70").run(10)
    rig.rig.do(command.Set(HOME, "scale", "left", "5")).do(command.Get(HOME, "scale", "left"))
    assert rig.rig.last(news.Got).value == 5


def test_whose_sandbox_has_ended_is_in_error_and_no_entry_mends_it():  # R-X16
    rig = Rig(answers=[])
    rig.on("70").run(3)
    rig.sandbox._answers = [None]
    rig.run(1)
    assert "the sandbox has ended" in rig.rig.last(news.Failed).text


@pytest.mark.parametrize(
    "answer",
    [
        b"\xc1",
        b"",
        encode(Declared(ModuleSheet((), (), (), False, False, False, 0, ""), (), ())),
        b"\x81\xa4type\xa4Load",
    ],
)
def test_what_cannot_be_understood_is_not_believed(answer):  # R-X16
    rig = Rig().on("70").run(3)
    rig.sandbox._answers = [answer]
    rig.run(1)
    assert "cannot be understood" in rig.rig.last(news.Failed).text


def test_an_answer_without_a_signal_of_ours_is_a_fault():  # R-X16
    rig = Rig().on("70").run(3)
    rig.sandbox._answers = [encode(Returned(signal=("JUMP", 0, False, 0, "")))]
    rig.run(1)
    assert rig.rig.news_of(news.Failed)


def test_its_code_is_exchanged_in_a_sandbox_of_its_own():  # R-C12
    rig = Rig().on("70").run(3)
    newer = structs.replace(rig.spawn, source=SOURCE.replace("self.N += 1", "self.N += 10"))
    sandbox = LocalSandbox(newer)
    rig.give(sandbox)
    rig.rig.do(command.Swap(newer))
    assert rig.sandbox.is_closed
    rig.run(1)
    assert rig.rig["N"] >= 13
    rig.rig.do(command.Kill(HOME, "scale"))
    assert sandbox.is_closed


def test_a_descriptor_does_not_leave_a_sandbox():
    source = SOURCE.replace("trigger = True", "").replace("return finish() if not self._left else None", "")
    rig = Rig(source, kind="synchronous", frequency=None).on("5")
    assert "no file descriptor" in rig.rig.last(news.Failed).text
