"""What a module raises: mended, ERROR, and what is told of it."""

import pytest

from kit.labs.module_source import COUNTER, cycle, module
from kit.runtime.executive_rig import HOME, ExecutiveRig, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news

MS = 1_000_000


# Errors

FAILS = "    def cycle(self):\n        x = 1\n        raise ValueError('planted')\n"


def test_an_error_is_told_with_file_line_and_traceback():  # R-A18
    source = module(FAILS)
    rig = rig_of(source).switch(on=["one"]).run(0)
    failed = rig.last(news.Failed)
    line = source.splitlines().index("        raise ValueError('planted')") + 1
    assert (failed.entry, failed.text, failed.path, failed.line) == ("cycle", "ValueError: planted", "one.py", line)
    assert f'File "one.py", line {line}' in failed.traceback
    assert "executive" not in failed.traceback
    assert rig.task("one").state is State.ERROR


def test_the_modules_error_entry_comes_first_and_may_mend():  # R-A09
    source = module(FAILS + "    def error(self, fault):\n        return str(fault) == 'planted'")
    rig = rig_of(source).switch(on=["one"]).run(30 * MS)
    assert rig.news_of(news.Failed) == []
    assert rig.task("one").state is State.ON


@pytest.mark.parametrize("answer", ["return False", "return None", "raise KeyError", "sys.exit()"])
def test_an_error_entry_that_gives_up_or_raises_leaves_the_error_as_it_was(answer):  # R-A09
    source = module(FAILS + f"    def error(self, fault):\n        {answer}")
    assert rig_of(source).switch(on=["one"]).run(0).last(news.Failed).text == "ValueError: planted"


def test_a_task_in_error_cycles_no_more_and_the_others_go_on():  # R-A05
    rig = ExecutiveRig().spawn("bad", module(FAILS)).spawn("good", COUNTER).switch(on=["bad", "good"]).run(50 * MS)
    assert len(rig.news_of(news.Failed)) == 1
    assert rig["N"] == 6


@pytest.mark.parametrize(("line", "text"), [("sys.exit(3)", "SystemExit: 3"), ("raise GeneratorExit", "GeneratorExit")])
def test_a_module_that_exits_ends_nobody_else(line, text):  # R-X12
    rig = rig_of(cycle(line)).switch(on=["one"]).run(20 * MS)
    assert rig.last(news.Failed).text == text


def test_a_cycle_that_raises_publishes_nothing():  # law 2
    source = module("    N = OutVar('int')\n    def cycle(self):\n        self.N = 5\n        raise ValueError")
    assert rig_of(source).switch(on=["one"]).run(0)["N"] == 0


@pytest.mark.parametrize("entry", ["on", "off", "clear"])
def test_what_raises_in_another_entry_is_an_error_by_its_name(entry):  # R-A05
    arguments = ", inputs" if entry == "on" else ""
    body = f"    def {entry}(self{arguments}):\n        raise ValueError('planted')\n"
    body += "    def cycle(self):\n        raise ValueError\n" if entry == "clear" else ""
    rig = rig_of(module(body)).switch(on=["one"]).run(0)
    if entry != "on":
        rig.do(command.Switch(HOME, ("one",), (), ()) if entry == "off" else command.Clear(HOME, "one"))
    assert rig.last(news.Failed).entry == entry
    assert rig.task("one").state is State.ERROR


def test_a_finish_whose_off_raises_is_an_error_and_no_finish():  # R-A08
    source = cycle("return finish()", trigger=True) + "    def off(self):\n        raise ValueError\n"
    rig = rig_of(source).switch(on=["one"]).run(0)
    assert rig.news_of(news.Finished) == []
    assert rig.task("one").state is State.ERROR


def test_a_kill_that_raises_is_told_and_the_task_is_gone():  # R-A05
    rig = rig_of(module("    def kill(self):\n        raise ValueError")).do(command.Kill(HOME, "one"))
    assert [type(event) for _, event in rig.news[-2:]] == [news.Failed, news.Changed]
    assert rig.executive.tasks == {}


@pytest.mark.parametrize("when", ["init", "cycle"])
def test_a_name_that_is_no_port_is_an_error(when):  # style §3, habit 5
    rig = rig_of(module(f"    def {when}(self):\n        self.Q_REFF = 1.0")).switch(on=["one"]).run(0)
    assert "Q_REFF is no port of this module: declare it or use another name" in rig.last(news.Failed).text


def test_an_input_cannot_be_written():  # R-A02
    source = module("    X = InVar('double')\n    def cycle(self):\n        self.X = 1.0")
    assert "X is an INVAR: it is read, never written" in rig_of(source).switch(on=["one"]).run(0).last(news.Failed).text
