"""What a module does to itself while it lives is noticed and named."""

import pytest

from kit.labs.module_source import COUNTER, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.execution.running_task import CHECKED_EVERY
from onika.runtime.modules.binding_guard import BindingGuard

MS = 1_000_000
PORTS = "    X = InVar('double[2]')\n    Y = OutVar('double[2]')\n    K = Local('int', default=1)\n"
TRICKS = [
    ("self.Q_REFF = 1.0", "Q_REFF is no port of this module: declare it or use another name"),
    ("self.N = 1.0; self.FOREIGN = 5", "FOREIGN is a variable of other tasks: this module has no port for it"),
    (
        "type(self).Z = OutVar('double')",
        "Z was declared or changed after the module was loaded: it is bound to nothing",
    ),
    ("type(self).Y = OutVar('double')", "Y was declared or changed after"),
    ("type(self).declared_ports['Z'] = OutVar('double')", "Z was declared or changed after"),
    ("del type(self).declared_ports['Y']", "Y was declared or changed after"),
    ("self.__class__ = Other", "it has turned from a One into a Other"),
    ("type(self).hardware = True", "hardware may not change after the module was loaded"),
    ("self.trigger = True", "trigger may not change after the module was loaded"),
    ("self._port_Y = [1.0, 2.0]", "the memory behind Y was exchanged: write into it"),
]


def tricky(line, at):
    """Does it in one of its cycles."""
    other = "\nclass Other(Module):\n    pass\n" if "Other" in line else ""
    body = f"    n = 0\n    def cycle(self):\n        self.n += 1\n        if self.n == {at}:\n            {line}"
    source = module(PORTS + body)
    return source.replace("\nclass One", f"{other}\nclass One") if other else source


def other_class(source):
    """A file may have one module only: the other class is made where no loader looks."""
    return source.replace(
        "\nclass Other(Module):\n    pass\n", "\nOther = type('Other', (Module,), {'__module__': 'x'})\n"
    )


@pytest.mark.parametrize(("line", "sentence"), TRICKS)
@pytest.mark.parametrize("at", [1, 10])
def test_whatever_a_module_does_to_itself_is_an_error_that_names_it(line, sentence, at):  # R-A12
    rig = ExecutiveRig().spawn("good", COUNTER).spawn("owner", module("    FOREIGN = OutVar('double')"))
    rig.spawn("one", other_class(tricky(line, at)), frequency=1000.0).switch(on=["good", "one"]).run(1100 * MS)
    assert rig.task("one").state is State.ERROR
    failed = rig.news_of(news.Failed)[0]
    assert sentence in failed.text
    assert (failed.now_ns // MS) == (0 if at == 1 else CHECKED_EVERY + 1)
    assert (rig["N"], rig.task("good").state) == (111, State.ON)


def test_what_a_module_changes_late_is_told_when_it_goes_off():  # R-A12, R-X12
    rig = ExecutiveRig().spawn("one", tricky("self.Q_REFF = 1.0", 3), frequency=100.0).switch(on=["one"]).run(100 * MS)
    assert rig.task("one").state is State.ON
    rig.switch(off=["one"])
    (failed,) = rig.news_of(news.Failed)
    assert failed.entry == "off"
    assert "Q_REFF is no port of this module" in failed.text


ENDS_ODDLY = module(
    "    def cycle(self):\n        if self.now >= 0.02:\n            self.Q_REFF = 1.0\n            return finish()",
    trigger=True,
)


def ends_oddly(on=(), then=()):
    """A trigger changes itself in its last cycle; `next` is prepared to follow it, and what is `on`; `then` comes."""
    rig = ExecutiveRig(react=lambda entry: [*then] if isinstance(entry, news.Finished) else [])
    rig.spawn("end", ENDS_ODDLY).spawn("next", COUNTER).switch(on=[command.Launch("end", "", None, 7)])
    following = command.Switch(HOME, (), (), tuple(command.Launch(task, "", None, 8) for task in ("next", *on)))
    rig.do(command.PreparedSwitch(HOME, "end", 7, (command.Case(None, None, 1, following),)))
    return rig.run(20 * MS)


def test_who_ends_a_job_is_looked_at_when_the_next_one_has_begun():  # R-A12, R-X12, law 6
    rig = ends_oddly()
    told = [entry for at, entry in rig.news if at == 20 * MS]
    assert [type(entry) for entry in told] == [news.Finished, news.Changed, news.Cycled, news.Failed]
    assert (rig.news_of(news.Failed)[0].entry, rig.task("end").state) == ("off", State.ERROR)
    assert rig.task("next").state is State.ON


def test_who_comes_on_again_at_once_is_looked_at_with_its_first_cycle():  # R-A12, R-X12
    rig = ends_oddly(on=["end"])
    assert (rig.news_of(news.Failed)[0].entry, rig.task("end").state) == ("check", State.ERROR)


@pytest.mark.parametrize("order", [command.Kill(HOME, "end"), command.Rebind(HOME, "end", ())])
def test_who_has_ended_a_job_is_looked_at_before_anything_is_done_to_it(order):  # R-A12, R-X12
    rig = ends_oddly(then=[order])
    assert "Q_REFF is no port of this module" in rig.news_of(news.Failed)[0].text


def test_a_slow_task_is_looked_at_after_about_a_second():  # R-A12, R-X12
    rig = ExecutiveRig().spawn("one", tricky("self.Q_REFF = 1.0", 3), frequency=10.0).switch(on=["one"]).run(2000 * MS)
    assert rig.task("one").state is State.ERROR


def test_no_error_entry_mends_it():  # R-A12
    body = "    def cycle(self):\n        self.Q_REFF = 1\n    def error(self, fault):\n        return True"
    assert ExecutiveRig().spawn("one", module(body)).switch(on=["one"]).run(0).task("one").state is State.ERROR


def test_whoever_writes_a_foreign_name_before_it_lives_is_named_too():  # R-A12
    body = "    def init(self):\n        self.FOREIGN = 1.0"
    rig = ExecutiveRig().spawn("owner", module("    FOREIGN = OutVar('double')")).spawn("one", module(body))
    assert "FOREIGN is a variable of other tasks" in rig.news_of(news.Failed)[0].text


def test_a_module_that_does_nothing_of_the_kind_is_left_alone():
    rig = ExecutiveRig().spawn(
        "one", module(PORTS + "    def cycle(self):\n        self.Y = 2.0 * self.X\n        self._k = self.K")
    )
    rig.switch(on=["one"]).run(3000 * MS)
    assert rig.task("one").state is State.ON
    assert BindingGuard(rig.task("one").module).faults() == []
