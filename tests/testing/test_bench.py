"""The bench for modules."""

import pytest

from onika.model.lifecycle import State
from onika.testing.bench import Bench

RAMP = '''
from onika.module import AskAgain, InConst, Input, InVar, Local, Module, OutVar, finish


class Ramp(Module):
    """Counts up to the input, scaled."""

    trigger = True
    N = InConst("int", "-", "elements")
    LABEL = InConst("string", "-", "a word")
    X = InVar("double[N]", "m", "what is scaled")
    Y = OutVar("double[N]", "m", "what comes of it")
    GAIN = Local("double", "-", "factor", default=2.0)
    count = Input("int", "-", "cycles", low=1, high=100)

    def on(self, inputs):
        if inputs.count == 13:
            raise AskAgain("not thirteen")
        self._left = inputs.count
        self._start = self.continues("Y")

    def cycle(self):
        self.Y = self.GAIN * self.X
        self._left -= 1
        if self.X[0] < 0.0:
            raise ValueError("X must not be negative")
        if self.X[0] > 100.0:
            self.warn("X is large")
        return finish(flow=1, loop=True) if self._left == 0 else None

    def get(self, name):
        return {"left": self._left, "continues": self._start, "label": self.LABEL}.get(name) or super().get(name)

    def set(self, name, value):
        if name != "left":
            super().set(name, value)
        self._left = int(value)
'''
CONSTANTS = {"N": 2, "LABEL": "lamp"}


@pytest.fixture
def ramp(tmp_path):
    file = tmp_path / "ramp.py"
    file.write_text(RAMP)
    return file


def test_inputs_are_set_and_outputs_read_by_name(ramp):
    bench = Bench(ramp, local={"GAIN": 3}, constants=CONSTANTS).init().on("5")
    bench["X"] = [1.0, 2.0]
    assert bench.cycle()["Y"].tolist() == [3.0, 6.0]


def test_a_trigger_that_finishes_ends_the_cycles(ramp):  # R-A08
    bench = Bench(ramp, constants=CONSTANTS, frequency=50).init().on("5").cycle(1000)
    assert (bench.cycles, bench.state) == (5, State.OFF)
    assert bench.now == pytest.approx(4 / 50)
    assert bench.finished is not None
    assert (bench.finished.flow, bench.finished.loop) == (1, True)


def test_cycles_of_a_task_that_is_not_on_are_a_mistake_of_the_test(ramp):
    bench = Bench(ramp, constants=CONSTANTS).init()
    with pytest.raises(RuntimeError, match="turn it on first"):
        bench.cycle()


def test_a_bad_argument_line_becomes_a_question_that_can_be_answered(ramp):  # R-A10
    bench = Bench(ramp, constants=CONSTANTS).init().on("1000")
    assert bench.state is State.ASKING
    assert bench.asked is not None
    assert "1..100" in bench.asked.reason
    assert bench.answer("13").asked.reason == "not thirteen"
    assert bench.answer("2").state is State.ON


def test_an_exception_puts_the_task_in_error_with_its_line(ramp):  # R-A09
    bench = Bench(ramp, constants=CONSTANTS).init().on("5")
    bench["X"] = [-1.0, 0.0]
    bench.cycle(3)
    assert bench.state is State.ERROR
    assert bench.failed is not None
    assert bench.failed.text == "ValueError: X must not be negative"
    assert RAMP.splitlines()[bench.failed.line - 1].strip().startswith("raise")
    assert bench.clear().state is State.OFF


def test_warnings_are_kept(ramp):
    bench = Bench(ramp, constants=CONSTANTS).init().on("5")
    bench["X"] = [101.0, 0.0]
    assert bench.cycle(2).warnings == ["X is large", "X is large"]


def test_an_output_is_in_force_once_it_was_written_and_not_forgotten(ramp):  # law 3
    bench = Bench(ramp, constants=CONSTANTS).init()
    bench["Y"] = [1.0, 1.0]
    assert bench.on("5").get("continues") is True
    with pytest.raises(RuntimeError, match="continues"):
        bench.off().forget("Y").on("5").get("continues")


def test_get_and_set_reach_the_module(ramp):
    bench = Bench(ramp, constants=CONSTANTS).init().on("5")
    bench.set("left", "1")
    assert bench.get("left") == 1
    assert bench.get("label") == "lamp"
    assert bench.cycle(9).cycles == 1
    with pytest.raises(RuntimeError, match="nothing called"):
        bench.set("right", "1")


def test_an_unknown_variable_is_named_with_the_known_ones(ramp):
    bench = Bench(ramp, constants=CONSTANTS)
    with pytest.raises(KeyError, match="expected one of N, LABEL, X, Y"):
        bench["Z"] = 1.0
    with pytest.raises(KeyError, match="found Z"):
        _ = bench["Z"]


def test_a_bad_parameter_is_refused_at_once(ramp):
    with pytest.raises(ValueError, match="expected a number"):
        Bench(ramp, local={"GAIN": "much"}, constants=CONSTANTS)


def test_an_input_of_another_shape_is_refused(ramp):
    bench = Bench(ramp, constants=CONSTANTS)
    with pytest.raises(ValueError, match="broadcast"):
        bench["X"] = [1.0, 2.0, 3.0]


def test_a_file_that_is_no_module_is_refused_at_once(tmp_path):
    file = tmp_path / "nothing.py"
    file.write_text("x = 1\n")
    with pytest.raises(ValueError, match="exactly one subclass of Module, found none"):
        Bench(file)


def test_a_killed_task_is_gone(ramp):
    bench = Bench(ramp, constants=CONSTANTS).init().on("5").kill()
    assert bench.state is State.KILLED


def test_an_aperiodic_module_runs_once_for_every_on(tmp_path):
    file = tmp_path / "once.py"
    file.write_text(
        "from onika.module import Module, OutVar\n"
        "class Once(Module):\n"
        "    COUNT = OutVar('int', '-', 'runs')\n"
        "    def cycle(self):\n"
        "        self.COUNT += 1\n"
    )
    bench = Bench(file, frequency=None).init().on().cycle(5)
    assert bench["COUNT"] == 1
    assert bench.off().on().cycle()["COUNT"] == 2


def test_texts_and_characters_lie_in_the_table_as_modules_see_them(tmp_path):
    file = tmp_path / "words.py"
    file.write_text(
        "from onika.module import InVar, Module, OutVar\n"
        "class Words(Module):\n"
        "    TEXT = InVar('string', '-', 'a text')\n"
        "    SIGN = InVar('char', '-', 'a sign')\n"
        "    COPY = OutVar('string', '-', 'both')\n"
        "    def cycle(self):\n"
        "        self.COPY = self.TEXT + self.SIGN\n"
    )
    bench = Bench(file).init().on()
    bench["TEXT"], bench["SIGN"] = "Grüße", "!"
    assert bench.cycle()["COPY"] == "Grüße!"
    with pytest.raises(ValueError, match="at most 255 bytes"):
        bench["TEXT"] = "x" * 256


def test_a_module_is_exchanged_for_that_of_another_file(tmp_path):  # R-X15
    old, new = tmp_path / "old.py", tmp_path / "new.py"
    source = "from onika.module import *\nclass One(Module):\n    N = OutVar('int')\n"
    source += "    def cycle(self):\n        self.N += 1"
    old.write_text(source)
    new.write_text(source.replace("+= 1", "+= 10") + "\n    def take(self, old):\n        pass")
    bench = Bench(old).init().on().cycle(2).swap(new).cycle(2)
    assert bench["N"] == 22
    new.write_text(source + "\n    def init(self):\n        raise ValueError('no')")
    assert bench.swap(new).why.startswith("init: ValueError: no")
    assert bench.cycle()["N"] == 32
