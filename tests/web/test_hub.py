import asyncio

import msgspec
import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.link.caller import Role
from onika.model.task import Task
from onika.web.access.entrance import OWNER, Visitor
from onika.web.hub import Hub
from onika.wire import act, page
from onika.words.reason import Reason

OTHER = Visitor("bob", Role.OWNER, "s2")
TASKS = (Task("a", "a", outvar=("Q",), frequency=1.0),)


class Values:
    """Newest values, as they would come from a runtime."""

    def __init__(self):
        self.wishes = []
        self.next = None

    def watch(self, variables, worlds, figures, hz):
        self.wishes.append((variables, worlds, figures, hz))

    def frame(self):
        return self.next


class Talk:
    """One browser, and what it was sent."""

    def __init__(self, hub, visitor=OWNER):
        self.hub = hub
        self.client = hub.come(visitor)

    def send(self, cid, request):
        self.hub.take(self.client, msgspec.json.encode(page.Ordered(cid, request)))

    def messages(self):
        async def take():
            messages = []
            while True:
                try:
                    messages.append(msgspec.json.decode(await asyncio.wait_for(self.client.outbox.next(), 0.01)))
                except TimeoutError:
                    return messages

        return self.hub.runner.run(take())


@pytest.fixture
def hub(tmp_path):
    hub = Hub(EnvironmentFixture(tmp_path, TASKS).environment, Values(), lambda: 12.5)
    with asyncio.Runner() as hub.runner:  # what waits for something belongs to one loop
        yield hub


def tree(messages):
    """The tree that a page has made of what it was sent."""
    by_kind = {}
    revision = None
    for message in messages:
        if message["t"] == "Snapshot":
            by_kind, revision = message["tree"], message["rev"]
        if message["t"] == "Patch":
            assert message["rev"] == revision + 1, "a gap"
            revision = message["rev"]
            for path, value in message["changes"]:
                at = by_kind
                for step in path[:-1]:
                    at = at.setdefault(step, {})
                if value is None:
                    at.pop(path[-1], None)
                else:
                    at[path[-1]] = value
    return msgspec.convert(by_kind, page.Tree)


def test_a_browser_is_told_everything_first_and_how_many_look(hub):
    Talk(hub)
    other = Talk(hub).messages()
    assert other[0]["t"] == "Snapshot"
    assert tree(other).people == 2


def test_every_act_gets_one_answer_after_its_patch(hub):
    talk = Talk(hub)
    talk.messages()
    talk.send(7, act.New())
    talk.send(8, act.Undo("c1"))
    patch, done, refused = talk.messages()
    assert (patch["t"], done["t"], done["cid"], done["value"]) == ("Patch", "Ok", 7, "c1")
    assert done["rev"] == patch["rev"]
    assert (refused["t"], refused["cid"]) == ("Refused", 8)


def test_several_browsers_stay_identical(hub):  # two browsers converge
    first, two = Talk(hub), Talk(hub)
    first.send(1, act.New())
    for number in range(20):
        talk = (first, two)[number % 2]
        talk.send(number, act.Place("c1", "a", 0, 0) if number == 2 else act.Move("c1", {"a": (number, number)}))
    late = Talk(hub)
    trees = [tree(talk.messages()) for talk in (first, two, late)]
    assert trees[0] == trees[1] == trees[2]
    assert trees[0].documents["c1"].tasks["a"].x == 19


def test_a_browser_that_leaves_is_counted_no_more(hub):
    first, two = Talk(hub), Talk(hub)
    hub.leave(two.client)
    assert tree(first.messages()).people == 1


@pytest.mark.parametrize(
    "body", ["", "{", "[]", '{"cid":1}', '{"cid":1,"act":{"t":"Nothing"}}', '{"cid":1,"act":{"t":"New","x":1}}']
)
def test_what_is_no_act_is_refused_and_the_browser_stays(hub, body):  # R-F01
    talk = Talk(hub)
    hub.take(talk.client, body)
    refused = [message for message in talk.messages() if message["t"] == "Refused"]
    assert [message["reason"]["key"] for message in refused] == ["desk.no_act"]
    assert refused[0]["cid"] == (1 if '"cid":1' in body else 0)


def test_each_browser_gets_the_values_it_watches_and_no_others(hub):  # R-C14, R-C27
    first, two, three = Talk(hub), Talk(hub), Talk(hub)
    first.send(1, act.Watch(("c1/Q",), hz=30.0))
    two.send(1, act.Watch(("c1/R",), ("boxes",), figures=True, hz=10.0))
    assert hub._watched.wishes[-1] == (frozenset({"c1/Q", "c1/R"}), frozenset({"boxes"}), True, 30.0)
    for talk in (first, two, three):
        talk.messages()
    hub._watched.next = page.Frame(1.5, {"c1/Q": [1.0], "c1/R": 2}, {"c1/a": {"cycle": 3}}, {"boxes": [0.0]})
    hub.pump()
    assert [frame["values"] for frame in first.messages()] == [{"c1/Q": [1.0]}]
    (frame,) = two.messages()
    assert (frame["values"], frame["figures"], frame["poses"]) == (
        {"c1/R": 2},
        {"c1/a": {"cycle": 3}},
        {"boxes": [0.0]},
    )
    assert three.messages() == []
    hub._watched.next = page.Frame(1.5, {"c1/R": 3})
    hub.pump()
    assert first.messages() == []


def test_a_line_is_told_at_once_with_its_time_and_again_to_whoever_comes(hub):
    talk = Talk(hub)
    talk.messages()
    hub.remember((page.Say("warning", Reason.plain("from before")),))
    hub.say(page.Say("info", Reason.plain("a word")))
    assert [(message["text"]["text"], message["at_s"]) for message in talk.messages()] == [("a word", 12.5)]
    late = [message["text"]["text"] for message in Talk(hub).messages() if message["t"] == "Say"]
    assert late == ["from before", "a word"]


def test_nobody_watching_is_known(hub):
    talk = Talk(hub)
    assert not hub.is_watching
    talk.send(1, act.Watch(("c1/Q",)))
    assert hub.is_watching
    hub.leave(talk.client)
    assert not hub.is_watching
    assert hub._watched.wishes[-1][:3] == (frozenset(), frozenset(), False)


def test_each_browser_is_told_who_it_is_and_what_it_may_do(hub):  # R-F10
    ann = Talk(hub, Visitor("ann", Role.OPERATOR, "s1"))
    told = ann.messages()[0]
    assert (told["you"], told["user"], told["role"]) == ("ann 1", "ann", "operator")
    assert "role" not in Talk(hub).messages()[0]
    assert hub.visitor("ann 1").user == "ann"
    assert hub.visitor("ann 2") is None
    assert hub.sessions == {"s1", ""}


def test_what_a_role_may_not_is_refused_with_its_number_and_told_on(hub):  # R-F10
    denied = []
    hub.denials.append(lambda visitor, command: denied.append((visitor.user, type(command))))
    talk = Talk(hub, Visitor("wil", Role.VIEWER, "s1"))
    before = hub._environment.model
    talk.send(9, act.New())
    refused = talk.messages()[-1]
    assert (refused["t"], refused["cid"], refused["reason"]["key"]) == ("Refused", 9, "desk.only_watch_and_stop")
    assert denied == [("wil", act.New)]
    assert hub._environment.model.documents == before.documents


def test_whoever_has_to_go_is_heard_no_more(hub):  # R-F10
    ann, bob, near = (Talk(hub, visitor) for visitor in (Visitor("ann", Role.OWNER, "s1"), OTHER, OWNER))
    hub.end("s1")
    hub.end("")
    assert [talk.client.ended.is_set() for talk in (ann, bob, near)] == [True, False, False]
    ann.send(1, act.New())
    assert hub._environment.model.documents == {}
