from dataclasses import replace

from onika.desk.environment.reconcile.live_facts import alive, settled, with_standing
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import History
from onika.desk.environment.state.live import Pending, SubsystemFacts, TaskFacts
from onika.desk.plan.compile import planned_task
from onika.model.configuration import Configuration
from onika.model.task import Task
from onika.wire import event
from onika.wire.runtime_standing import Standing, SubsystemStanding, TaskStanding
from onika.words.reason import Reason


def standing(*tasks, holder="me"):
    home = SubsystemStanding("main", holder, "", tasks)
    return Standing((home,), (), (), True, False, 0.0)


def task(name, state, reason=""):
    planned = planned_task(Task(name, name, frequency=10.0), "unknown", "0", f"{name}.rmod")
    return TaskStanding(planned, state, False, "rt1", 20.0, reason)


def document(wanted, **states):
    facts = SubsystemFacts("main", "live", {name: TaskFacts(state) for name, state in states.items()})
    return Document("c1", Content(Configuration("c"), wanted), live=facts)


def test_what_is_wanted_follows_the_facts():  # R-C11, law 22
    wanted = {"off": True, "on": False, "asks": False, "broken": True, "dead": True, "born": True}
    states = {"off": "OFF", "on": "ON", "asks": "ASKING", "broken": "ERROR", "born": "SPAWNING"}
    assert settled(document(wanted, **states)).content.wanted == {
        "off": False, "on": True, "asks": True, "broken": True, "dead": False, "born": True,
    }  # fmt: skip


def test_nothing_follows_while_something_is_under_way_or_nothing_is_known():
    shown = document({"a": True}, a="OFF")
    pending = Pending(shown.content, shown.content, History(), History())
    assert settled(replace(shown, live=replace(shown.live, pending={1: pending}))).content is shown.content
    assert settled(replace(shown, live=replace(shown.live, state="lost"))).content is shown.content
    assert settled(replace(shown, live=None)).content is shown.content


def test_dead_tasks_are_not_alive():
    assert list(alive(standing(task("a", "OFF"), task("b", "KILLED")), "main")) == ["a"]
    assert alive(standing(), "elsewhere") == {}


def test_the_facts_are_taken_over_and_a_question_is_kept_as_long_as_it_is_asked():
    question = event.Asked("main", "a", Reason.plain("too far"), (), 0.0)
    facts = SubsystemFacts(
        "main", "live", {"a": TaskFacts("ASKING", question=question, warnings=3), "gone": TaskFacts("ON")}
    )
    now = with_standing(facts, standing(task("a", "ASKING", "asks for x"), task("b", "WAITING", "waits for N")))
    planned = task("a", "ASKING").task
    assert now.tasks["a"] == TaskFacts("ASKING", rtpu="rt1", hz=20.0, question=question, warnings=3, planned=planned)
    assert str(now.tasks["b"].note) == "waits for N" and set(now.tasks) == {"a", "b"} and now.holder == "me"
    later = with_standing(now, standing(task("a", "OFF")))
    assert later.tasks["a"].question is None


def test_a_question_that_was_asked_before_is_known_to_whoever_connects():  # R-X12, R-C13
    question = event.Asked("main", "a", Reason.plain("too far"), (), 0.0)
    home = SubsystemStanding("main", "me", "", (task("a", "ASKING", "asks for x"),), (question,))
    now = with_standing(SubsystemFacts("main", "live"), Standing((home,), (), (), True, False, 0.0))
    assert (now.tasks["a"].question, str(now.tasks["a"].note)) == (question, "")


def test_who_is_about_to_be_born_is_so_until_that_is_done():
    pending = Pending(Content(Configuration("c")), Content(Configuration("c")), History(), History())
    facts = SubsystemFacts("main", "live", {"a": TaskFacts("SPAWNING")}, pending={1: pending})
    assert with_standing(facts, standing()).state_of("a") == "SPAWNING"
    assert with_standing(facts, standing(task("a", "OFF"))).state_of("a") == "SPAWNING"
    assert with_standing(replace(facts, pending={}), standing(task("a", "OFF"))).state_of("a") == "OFF"
