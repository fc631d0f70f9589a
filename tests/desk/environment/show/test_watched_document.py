from onika.desk.environment.show.watched_document import in_run
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.live import WatchedRun
from onika.model.configuration import Configuration, Placed
from onika.wire.view import LivingTaskView, SubsystemView
from onika.words.reason import Reason

WHY = Reason.plain("the arm is gone")
CONTENT = Content(Configuration("jmoveC", placed=(Placed("puma"), Placed("traj"))))
DOCUMENT = Document("c1", CONTENT, watched=WatchedRun("flow0", "play"))


def test_its_tasks_are_as_they_are_in_the_run_and_nothing_is_wanted():  # R-C15, R-E11
    tasks = {"traj": LivingTaskView("ERROR", WHY, "rt1", 20.0), "grip": LivingTaskView("ON")}
    shown = in_run(DOCUMENT, SubsystemView("play", tasks), "anna", "me", ())
    assert list(shown.live.tasks) == ["traj"]
    facts = shown.live.tasks["traj"]
    assert (facts.state, facts.note, facts.rtpu, facts.hz) == ("ERROR", WHY, "rt1", 20.0)
    assert (shown.live.subsystem, shown.live.is_foreign, shown.live.base) == ("flow0", True, None)
    assert shown.content is DOCUMENT.content


def test_what_stands_for_a_task_is_shown_at_the_one_that_is_named():  # R-E11
    tasks = {"scara": LivingTaskView("ON"), "traj": LivingTaskView("OFF")}
    shown = in_run(DOCUMENT, SubsystemView("play", tasks), "", "", (("puma", "scara"),))
    assert {name: task.state for name, task in shown.live.tasks.items()} == {"puma": "ON", "traj": "OFF"}


def test_what_looks_into_nothing_is_shown_as_it_is():
    plain = Document("c1", CONTENT)
    assert in_run(plain, SubsystemView("play"), "", "", ()) is plain
