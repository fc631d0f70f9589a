import pytest

from kit.plans.plan_builder import PlanBuilder
from kit.runtime.live_edits import BROKEN, COUNTER, SOURCE, live_edits_with_tasks
from onika.host.edit import transactions
from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.model.rules.reconfiguration import exchange
from onika.ring.segment import Segment
from onika.runtime import news
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.table import Table
from onika.runtime.wiring import wire
from onika.wire import event, live
from onika.wire.request import Stop
from onika.words.reason import Reason


@pytest.fixture
def hand():
    return live_edits_with_tasks()


def test_a_change_that_waits_finds_what_those_before_it_leave(hand):  # law 22
    wishes = [
        hand.order(("source",), ("source",)),
        hand.order(("user",), ("user",)),
        live.Change("s0", off=("user",)),
        live.Change("s0", kill=("source", "user")),
        live.Change("s0", on=(live.Turn("user"),)),
        hand.order(("source",)),
    ]
    tickets = [hand.asker.send(wish) for wish in wishes]
    hand.work()
    numbers = [hand.asker.server.replies[ticket].number for ticket in tickets]
    outcomes = [hand.edited(number) for number in numbers]
    assert outcomes[:4] == [[""]] * 4
    assert outcomes[4] == ["expected one of no task, found user"]
    assert outcomes[5] == [""]
    assert hand.states == {"source": "OFF"}


def test_what_was_asked_of_a_task_that_is_gone_when_its_turn_comes_is_refused(hand):  # law 22
    hand.change(spawn=["source", "user"], on=["source"])
    first = hand.asker.send(live.Change("s0", kill=("user",), off=("source",)))
    late = [hand.asker.send(live.Reinit("s0", "user")), hand.asker.send(live.Swap("s0", "user", *hand.code("user")))]
    hand.work()
    assert hand.edited(hand.asker.server.replies[first].number) == [""]
    for ticket in late:
        assert hand.edited(hand.asker.server.replies[ticket].number) == ["user: it was changed or ended meanwhile"]


def test_a_stop_in_the_midst_of_a_change_leaves_nothing_hanging(hand):  # law 27
    hand.change(spawn=["source", "counter"], on=["source", "counter"])
    hand.task("other", SOURCE, module="other")
    ticket = hand.asker.send(hand.order(("other",), ("other",), kill=("source",)))
    hand.asker.ask(Stop(Reason.plain("enough")))
    hand.work()
    assert len(hand.edited(hand.asker.server.replies[ticket].number)) == 1
    assert set(hand.states.values()) == {"OFF"}
    hand.asker.ask(live.Reset())
    assert hand.change(on=[name for name in hand.states if name != "counter"][:1]) == ""


def exchange_of_suppliers(hand):
    hand.task("other", SOURCE, module="other", local={"SIZE": "3"}, rtpu="rt1")
    return hand.order(("other",), ("other",), kill=("source",), off=("counter",))


def birth(hand):
    hand.task("new", COUNTER.replace("COUNT", "NEW"), rtpu="rt0")
    hand.task("newer", COUNTER.replace("COUNT", "NEWER"), rtpu="rt1")
    hand.task("newest", COUNTER.replace("COUNT", "NEWEST"), rtpu="rt0")
    return hand.order(("new", "newer", "newest"), ("new", "newer", "newest"))


def failing_birth(hand):
    hand.task("broken", BROKEN.replace("LEVEL", "ELSE"), rtpu="rt0")
    hand.task("source", SOURCE, rtpu="rt1")
    return hand.order(("source", "broken"), ("source",), kill=("source",))


def failing_start(hand):
    hand.task("other", SOURCE, module="other", local={"SIZE": "9"}, rtpu="rt0")
    return hand.order(("other",), ("other",), kill=("source",))


def dimension(hand):
    return live.Reinit("s0", "source", (("SIZE", ("3",)),))


def refused_dimension(hand):
    return live.Reinit("s0", "source", (("SIZE", ("9",)),))


def new_code(hand):
    return live.Swap("s0", "user", *hand.code("user"))


def end(hand):
    return live.Close("s0")


CHANGES = [exchange_of_suppliers, birth, failing_birth, failing_start, dimension, refused_dimension, new_code, end]


@pytest.mark.parametrize("lost", ["rt0", "rt1"])
@pytest.mark.parametrize("change", CHANGES, ids=[kind.__name__ for kind in CHANGES])
def test_a_unit_lost_at_any_moment_leaves_nothing_hanging(change, lost):  # R-X10, R-E10
    for moment in range(1, 100):
        hand = live_edits_with_tasks(("rt0", "rt1"), user="rt1", counter="rt1")
        everyone = ["source", "user", "reader", "counter"]
        hand.change(spawn=everyone, on=everyone)
        number = hand.asker.ask(change(hand))
        hand = live_edits_with_tasks(("rt0", "rt1"), user="rt1", counter="rt1")
        hand.change(spawn=everyone, on=everyone)
        hand.driver.fatal = (moment, lost)
        ticket = hand.asker.send(change(hand))
        hand.work()
        is_through = hand.driver.fatal is not None
        if is_through:
            hand.driver.lose(lost)
        hand.work()
        accepted = hand.asker.server.replies[ticket]
        assert accepted == number
        assert len(hand.edited(accepted.number)) == 1
        subsystem = hand.asker.program.subsystems.live.get("s0")
        assert subsystem is None or not subsystem.is_busy
        truth = {task: state.state.value for (_, task), state in hand.driver.living().items()}
        assert {name: task.state for name, task in hand.standing().items() if task.state != "WAITING"} == truth
        assert all(task.rtpu != lost or task.state == "WAITING" for task in hand.standing().values())
        hand.task("after", COUNTER.replace("COUNT", "AFTER"), rtpu="rt0" if lost == "rt1" else "rt1")
        assert hand.change(spawn=["after"], on=["after"]) == ""
        if is_through:
            return
    raise AssertionError("the change is never through")


def test_a_unit_that_is_gone_takes_no_tasks(hand):  # reading 12
    hand = live_edits_with_tasks(("rt0", "rt1"), source="rt1")
    hand.driver.lose("rt1")
    assert "rt1 was lost" in hand.change(spawn=["source"])
    assert hand.states == {}
    assert hand.change(spawn=["counter"], on=["counter"]) == ""


def test_other_subsystems_with_the_same_names_are_not_touched():  # R-A06
    hand = live_edits_with_tasks()
    everyone = ["source", "user", "counter"]
    for subsystem in ("s0", "s1"):
        assert hand.change(spawn=everyone, on=everyone, subsystem=subsystem) == ""
    hand.let_pass(1.0)
    before = hand.values("N", "LEVEL", "COUNT", subsystem="s1")
    hand.asker.server.events.clear()
    assert hand.reinit("source", SIZE="3") == ""
    assert hand.change(kill=everyone) == ""
    assert {message.subsystem for message in hand.asker.of(event.TaskState)} == {"s0"}
    assert hand.values("N", "LEVEL", "COUNT", subsystem="s1") == before
    hand.let_pass(1.0)
    assert hand.values("COUNT", subsystem="s1")["COUNT"] == before["COUNT"] + 50.0


# News in another order than virtual time has it


class Units:
    """Takes commands and carries none out."""

    def __init__(self):
        self.orders = []

    def send(self, rtpu, order):
        self.orders.append((rtpu, order))

    def grant(self, rtpu, device):
        raise ValueError(f"no {device}")

    def release(self, device):
        raise KeyError(device)


@pytest.fixture
def bare():
    """A subsystem whose units only listen, with a change of two tasks under way, and what it tells."""
    messages, shop = [], PlanBuilder()
    segment = Segment.create("test", 1 << 18)
    subsystem = LiveSubsystem("s0", Table(segment), Units(), messages.append, lambda: 0)
    new = []
    for name, rtpu in (("quick", "rt0"), ("slow", "rt1")):
        planned = shop.task(name, COUNTER.replace("COUNT", name.upper()), rtpu=rtpu)
        code = shop.code(name)
        subsystem.executor.spawner.add_code(code)
        new.append((wire(planned, sheet_of(load(code.source, code.path, code.module))), rtpu))
    order = exchange([], (), [wired.placed for wired, _ in new])
    subsystem.begin(
        1,
        transactions.change(
            subsystem, transactions.Edit(order, tuple(new), on=(live.Turn("quick"), live.Turn("slow")))
        ),
    )
    for name, rtpu in (("quick", "rt0"), ("slow", "rt1")):
        subsystem.hear(rtpu, news.Initialised("s0", name), 1)
    yield subsystem, messages
    segment.close()


def outcomes(messages):
    return [str(message.cause) for message in messages if isinstance(message, event.Edited)]


def test_a_job_that_is_done_before_another_has_begun_is_no_reason_to_wait(bare):  # law 22
    subsystem, messages = bare
    subsystem.hear("rt0", news.Changed("s0", "quick", "ON", 2), 2)
    subsystem.hear("rt0", news.Finished("s0", "quick", 0, False, 3), 3)
    assert outcomes(messages) == []
    subsystem.hear("rt1", news.Changed("s0", "slow", "ON", 4), 4)
    assert outcomes(messages) == [""]
    assert not subsystem.desired.is_on("quick")
    assert subsystem.desired.is_on("slow")


def test_who_is_to_come_on_after_one_whose_unit_is_lost_is_not_held_up(bare):  # R-E10
    subsystem, messages = bare
    subsystem.lost("rt0", "rt0 is gone", 2)
    assert outcomes(messages) == []
    subsystem.hear("rt1", news.Changed("s0", "slow", "ON", 3), 3)
    subsystem.hear("rt1", news.Changed("s0", "slow", "OFF", 4), 4)
    subsystem.hear("rt1", news.Changed("s0", "slow", "KILLED", 5), 5)
    assert outcomes(messages) == ["quick: rt0 is gone"]
    assert subsystem.members == {}


def test_a_birth_that_was_refused_is_taken_back(bare):  # R-X10
    subsystem, messages = bare
    subsystem.hear("rt0", news.Refused("s0", "quick", "on", Reason.plain("no")), 2)
    subsystem.hear("rt1", news.Changed("s0", "slow", "ON", 3), 3)
    subsystem.hear("rt1", news.Changed("s0", "slow", "OFF", 4), 4)
    for name, rtpu in (("quick", "rt0"), ("slow", "rt1")):
        subsystem.hear(rtpu, news.Changed("s0", name, "KILLED", 5), 5)
    assert outcomes(messages) == ["quick: on: no"]
    assert subsystem.is_empty


def test_a_refusal_that_no_change_waits_for_is_told(bare):
    subsystem, messages = bare
    for name, rtpu in (("quick", "rt0"), ("slow", "rt1")):
        subsystem.hear(rtpu, news.Changed("s0", name, "ON", 2), 2)
    subsystem.hear("rt0", news.Refused("s0", "quick", "rank", Reason.plain("no such task")), 3)
    assert (messages[-1].task, str(messages[-1].text)) == ("quick", "refused, rank: no such task")


def test_words_of_strangers_change_nothing(bare):
    subsystem, messages = bare
    before = list(messages)
    subsystem.hear("rt0", news.Changed("s0", "nobody", "ON", 2), 2)
    subsystem.hear("rt0", news.Statuses("rt0", 0.0, ()), 2)
    assert messages == before
