"""Tasks that ask an outside partner: nobody else waits."""

import select

import pytest

from kit.labs.module_source import COUNTER, module
from kit.runtime.executive_rig import HOME, rig_of
from onika.model.lifecycle import State
from onika.runtime import command, news
from onika.testing.fake_partner import FakePartner

MS = 1_000_000


# Tasks with an outside partner

ASKS = """
    N = OutVar('int')
    PARTNER = Local('line')
    PATIENCE = Local('double', default=10.0)
    def init(self):
        self.partner = Partner(self.PARTNER, patience_s=self.PATIENCE)
    def cycle(self):
        self.partner.ask('count', n=self.N)
    def sync(self):
        self.N = self.partner.answer.number('n', -100, 100)
"""


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


def asking(outsider, patience="10.0", body=ASKS, kind="synchronous", **flags):
    """A rig whose task `one` is ON and asks this partner."""
    local = (("PARTNER", (outsider.address,)), ("PATIENCE", (patience,)))
    return rig_of(module(body, **flags), kind=kind, local=local).switch(on=["one"])


def settle(rig):
    """Wait as an RTPU does, and run the task whose event has come, until its question is settled."""
    while rig.executive.owed() or rig.executive.settled():
        ready, _, _ = select.select(list(rig.executive.events()), [], [], 0.01)
        if ready or rig.executive.settled():
            rig._hear(rig.executive.event((HOME, "one"), rig.now), rig.now)


def test_a_task_with_a_partner_asks_at_its_rate_and_only_after_the_answer(outsider):  # R-F04
    rig = asking(outsider).run(55 * MS)
    call = outsider.accept()
    question = call.read()
    assert (question["id"], question["task"], rig.task("one").counters.cycles) == (1, "rig/one", 1)
    assert rig.executive.next_release() is None, "until the answer it is not due again"
    call.answer(question, n=7)
    rig.now = 55 * MS
    settle(rig)
    assert (rig["N"], rig.executive.next_release()) == (7, 60 * MS)
    rig.run(65 * MS)
    assert call.read()["n"] == 7
    assert rig.task("one").slot.missed == 0


def test_other_tasks_never_wait_for_a_partner(outsider):  # R-F04
    rig = asking(outsider).spawn("two", COUNTER, aliases={"N": "M"}).switch(on=["two"]).run(95 * MS)
    assert rig["M"] == 10
    assert rig.executive.owed() == [rig.task("one").partner.fileno()]
    assert list(rig.executive.speaking) == [(HOME, "one")]


@pytest.mark.parametrize("data", [b"nonsense\n", b'{"id": 1, "n": NaN}\n', b'{"id": 1, "n": 1e999}\n'])
@pytest.mark.parametrize("passive", [False, True])
def test_without_an_answer_a_passive_task_falls_silent_and_any_other_has_a_fault(outsider, data, passive):  # R-F04
    rig = asking(outsider, passive=passive).run(5 * MS)
    call = outsider.accept()
    call.read()
    call.say(data)
    settle(rig)
    state = State.OFF if passive else State.ERROR
    assert (rig.task("one").state, rig["N"]) == (state, 0)
    text = rig.last(news.Warned).text if passive else rig.last(news.Failed).text
    assert f"partner {outsider.address}: expected" in text
    if passive:
        assert text.endswith("it goes off")
        assert rig.last(news.Changed).signal == "OFF"
    assert rig.executive.owed() == []


@pytest.mark.parametrize("value", ["[1]", '"7"', "null", "1e6", "true"])
def test_a_false_answer_is_a_fault_and_writes_nothing(outsider, value):  # R-F04: it never reaches an actuator
    rig = asking(outsider).run(5 * MS)
    call = outsider.accept()
    call.read()
    call.say(b'{"id": 1, "n": %s}\n' % value.encode())
    settle(rig)
    assert (rig.task("one").state, rig["N"]) == (State.ERROR, 0)
    assert "ModuleError: expected n" in rig.last(news.Failed).text


def test_a_partner_that_never_answers_costs_its_own_task_only(outsider):  # R-F04
    rig = asking(outsider, patience="0.03").run(5 * MS)
    settle(rig)
    assert "no answer within 0.03 s" in rig.last(news.Failed).text
    rig.do(command.Clear(HOME, "one")).switch(on=["one"]).run(15 * MS)
    call = outsider.accept()
    call.read()
    question = call.read()
    call.answer(question, n=3)
    settle(rig)
    assert (rig["N"], rig.task("one").state) == (3, State.ON)


def test_an_error_entry_may_mend_it_and_the_task_asks_again(outsider):  # R-A09, R-F04
    body = ASKS + "    def error(self, fault):\n        self.N = 99\n        return True\n"
    rig = asking(outsider, body=body).run(5 * MS)
    call = outsider.accept()
    call.answer(call.read(), error="busy")
    settle(rig)
    assert rig.task("one").state is State.ON
    rig.run(15 * MS)
    call.answer(call.read(), n=4)
    settle(rig)
    assert rig["N"] == 4


def test_a_periodic_task_looks_for_its_answer_itself_and_a_fault_is_one_of_its_cycle(outsider):  # R-F04
    body = ASKS.replace("def cycle(self):", "def on(self, inputs):") + (
        "    def cycle(self):\n        if self.partner.has_answered():\n            self.sync()\n"
    )
    rig = asking(outsider, body=body, kind="periodic").run(25 * MS)
    call = outsider.accept()
    assert rig.executive.owed()
    assert rig.executive.settled() == []
    call.answer(call.read(), n=5)
    rig.run(35 * MS)
    assert (rig["N"], rig.task("one").counters.cycles) == (5, 4)


def test_off_ends_the_question_and_kill_the_connection(outsider):  # R-F04
    rig = asking(outsider).run(5 * MS)
    call = outsider.accept()
    call.read()
    rig.switch(off=["one"])
    assert (rig.executive.owed(), list(rig.executive.speaking), call.has_ended()) == ([], [], False)
    rig.do(command.Kill(HOME, "one"))
    assert call.has_ended()


def test_an_exchange_of_the_module_has_the_new_one_ask(outsider):  # R-F04, law 21
    rig = asking(outsider).run(5 * MS)
    first = outsider.accept()
    first.read()
    local = (("PARTNER", (outsider.address,)),)
    source = module(ASKS.replace("'count'", "'sum'"))
    rig.do(command.Swap(rig.spawn_of("one", source, kind="synchronous", local=local)))
    assert first.has_ended()
    rig.run(15 * MS)
    call = outsider.accept()
    question = call.read()
    assert question["ask"] == "sum"
    call.answer(question, n=6)
    settle(rig)
    assert (rig["N"], rig.executive.next_release()) == (6, 20 * MS)
