"""A unit begins by itself at an agreed time, and holds by itself what has begun alone (law 34, decision 56)."""

import pytest

from kit.labs.module_source import HEAD, module
from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.runtime.execution.appointments import SHARED_LATE_NS

MS = 1_000_000
ARM = """
class One(Module):
    hardware = True
    F = InVar("double", "N", "force")
    X = OutVar("double", "m", "place")

    def cycle(self):
        self.X = self.device.read()[0]
        self.device.write((self.F,))
"""
FORCE = module("    F = OutVar('double')\n    def cycle(self):\n        self.F = 1.0")
ASKS = module("    def init(self):\n        self.partner = Partner('unix:/nobody', '', 1.0)")
AT, HOLD = 200 * MS, 80 * MS


@pytest.fixture
def rig():
    """An arm that is ON and held, and a task that is to push it from the agreed time on."""
    rig = ExecutiveRig(MassWorld()).spawn("arm", HEAD + ARM, device="m0", frequency=1000.0)
    rig.spawn("force", FORCE, rank=1, frequency=1000.0).switch(on=["arm"]).run(10 * MS)
    switch = command.Switch(HOME, (), (), (command.Launch("force", activation=5),))
    return rig.do(command.Appointment(1, AT, HOLD, (HOME,), (switch,)))


def pushed_until(rig):
    """When the arm's drive was last driven."""
    return rig.bus.world.state("m0")[1] == 0.0


def test_it_begins_at_its_time_when_it_is_permitted(rig):
    rig.begin_words.permit(1)
    rig.run(AT - 1)
    assert rig.task("force").state is State.OFF
    rig.run(AT)
    assert rig.task("force").state is State.ON
    assert rig.last(news.Appointed) == news.Appointed(1, AT, has_begun=True)
    assert [each.now_ns for each in rig.news_of(news.Changed) if each.task == "force"] == [AT]


def test_it_does_not_begin_when_it_is_not_permitted(rig):
    rig.run(500 * MS)
    assert rig.task("force").state is State.OFF
    assert rig.last(news.Appointed) == news.Appointed(1, AT, has_begun=False)
    assert rig.news_of(news.HeldAlone) == []


def test_what_has_begun_alone_is_held_by_itself(rig):
    rig.begin_words.permit(1)
    rig.run(AT + HOLD - 1)
    assert pushed_until(rig)
    rig.run(AT + HOLD + MS)
    assert not pushed_until(rig)
    assert rig.task("arm").state is State.ERROR
    assert rig.last(news.HeldAlone) == news.HeldAlone(1, AT + HOLD)
    assert "nobody said in time" in rig.last(news.Failed).text


def test_what_is_confirmed_goes_on(rig):
    rig.begin_words.permit(1)
    rig.run(AT + 5 * MS)
    rig.begin_words.confirm(1)
    rig.run(AT + 500 * MS)
    assert pushed_until(rig)
    assert rig.news_of(news.HeldAlone) == []


def test_it_is_held_at_once_when_another_says_that_he_has_not_begun(rig):
    rig.begin_words.permit(1)
    rig.run(AT + 5 * MS).do(command.CallOff(1, holds=True)).run(AT + 7 * MS)
    assert not pushed_until(rig)
    rig.run(AT + 500 * MS)
    assert rig.news_of(news.HeldAlone) == []


def test_what_is_dismissed_before_its_time_never_begins(rig):
    rig.begin_words.permit(1)
    rig.do(command.CallOff(1)).do(command.CallOff(9)).run(500 * MS)
    assert rig.task("force").state is State.OFF
    assert rig.news_of(news.Appointed) == []


def test_a_stop_ends_what_was_appointed(rig):  # law 27
    rig.begin_words.permit(1)
    rig.run(50 * MS).do(command.Stop()).run(500 * MS)
    assert rig.last(news.Appointed) == news.Appointed(1, 50 * MS, has_begun=False)
    assert rig.task("force").state is State.OFF


def test_a_unit_that_shares_its_processor_may_begin_later(rig):  # law 34
    rig.begin_words.permit(1)
    rig.executive.share_processor()
    rig.executive.run_due(AT + SHARED_LATE_NS, 1)
    assert rig.task("force").state is State.ON


def test_what_begins_drives_something_where_a_task_of_its_subsystems_has_a_device(rig):  # decision 56
    rig.begin_words.permit(1)
    rig.run(AT)
    assert rig.last(news.Appointed).drives
    rig.begin_words.permit(2)
    rig.do(command.Appointment(2, AT + MS, HOLD, ("another",))).run(AT + MS)
    assert not rig.last(news.Appointed).drives


def test_an_outside_partner_counts_as_something_that_is_driven():  # decision 56
    rig = ExecutiveRig().spawn("asks", ASKS)
    rig.begin_words.permit(1)
    rig.do(command.Appointment(1, AT, HOLD, (HOME,))).run(AT)
    assert rig.last(news.Appointed).drives


def test_a_unit_without_tasks_that_are_on_keeps_its_appointment():
    rig = ExecutiveRig().spawn("force", FORCE)
    rig.begin_words.permit(7)
    rig.do(command.Appointment(7, AT, HOLD, (HOME,)))
    assert rig.executive.next_release() == AT
    rig.run(AT)
    assert rig.last(news.Appointed) == news.Appointed(7, AT, has_begun=True, drives=False)


def test_devices_of_other_subsystems_are_not_held(rig):
    switch = command.Switch(HOME, (), (), (command.Launch("force"),))
    rig.do(command.Appointment(1, AT, HOLD, ("another",), (switch,)))
    rig.begin_words.permit(1)
    rig.run(500 * MS)
    assert pushed_until(rig)
    assert rig.last(news.HeldAlone).number == 1
