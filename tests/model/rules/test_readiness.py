from collections.abc import Mapping

from onika.model.application import AppFlow, Application, Hole, Icon
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.redirect import Redirect
from onika.model.rules.readiness import faults
from onika.model.syntax import IconType, Syntax
from onika.model.task import Task
from onika.words.fault import Place, parted

KINDS = {
    "Application start": (0, 0),
    "Application end": (0, 0),
    "Complete job": (0, 0),
    "Complete application": (0, 0),
    "Complete NOP": (0, 0),
    "Joint job": (0, 1),
    "Joint application": (0, 1),
    "Joint object": (1, 0),
    "Cartesian job": (0, 2),
    "Cartesian object": (2, 0),
}
SYNTAX = Syntax(tuple(IconType(name, *edges) for name, edges in KINDS.items()), ())
PLACE = Place("work.appl")
TASKS = {
    "jmove": Task("jmove", "jmove", outvar=("Q_REF",), object_type="Joint job"),
    "grip": Task("grip", "grip", outvar=("GRIP",)),
}


def conf(name: str, *tasks: str) -> Configuration:
    return Configuration(name, tuple(map(Placed, tasks)))


CONFIGURATIONS = {"move": conf("move", "jmove"), "close": conf("close", "grip")}


def icon(name: str, kind: str) -> Icon:
    return Icon(Onikon(name, kind, "", (), blank()))


MOVE, THERE, CLOSE = icon("move", "Joint job"), icon("there", "Joint object"), icon("close", "Complete job")
NOP = icon("wait", "Complete NOP")


def result(
    *flows: tuple[Icon | Hole, ...],
    configurations: Mapping[str, Configuration] = CONFIGURATIONS,
    tasks: Mapping[str, Task] = TASKS,
    applications: Mapping[str, Application] | None = None,
) -> list[str]:
    application = Application("work", len(flows) > 1, tuple(map(AppFlow, flows)))
    given = faults(application, SYNTAX, configurations, tasks, PLACE, applications=applications)
    wrong, notes = parted(given)
    assert notes == ()
    assert all(str(fault.instead) == "the application is not run" for fault in wrong)
    files = {fault.place.file for fault in wrong}
    assert files <= {PLACE.file, *(f"{name}.appl" for name in applications or {})}
    return [f"{fault.reason}" for fault in given]


def test_what_is_there_and_at_fault_itself_is_not_missed():  # R-B07
    application = Application("work", False, (AppFlow((CLOSE, icon("move", "Complete job"))),))
    there = {"close": CONFIGURATIONS["close"]}
    missed = faults(application, SYNTAX, there, {}, PLACE)
    assert [str(fault.reason) for fault in missed] == [
        "expected the configuration move, found none for `move`, step 1 of flow 0",
        "expected the task grip, found none for `close`, step 0 of flow 0",
    ]
    assert faults(application, SYNTAX, there, {}, PLACE, unread=frozenset({"move", "grip"})) == ()


def test_a_whole_application_is_ready() -> None:
    assert result((MOVE, THERE, CLOSE, NOP)) == []  # R-E01


def test_an_application_needs_flows_and_flows_need_actions() -> None:
    assert result() == ["expected at least one flow, found none"]
    assert result((CLOSE,), ()) == ["expected an action in flow 1, found none"]


def test_every_fault_is_named_at_once() -> None:
    strange = icon("there", "Strange object")  # R-E01
    lost = icon("lost", "Complete job")
    assert result((MOVE, Hole(), lost, strange), (THERE, CLOSE)) == [
        "expected an application without holes, found a hole, step 1 of flow 0",
        "expected a type the syntax defines, found Strange object of `there`, step 3 of flow 0",
        "expected an action that takes this target, found none before `there`, step 0 of flow 1",
        "expected edges that fit, found `there` (Joint object) behind Application start, at step 0 of flow 1",
        "expected the configuration lost, found none for `lost`, step 2 of flow 0",
    ]


def test_a_job_needs_its_target() -> None:
    assert result((MOVE, CLOSE)) == [
        "expected a Joint object behind it, found none behind `move`, step 0 of flow 0",
        "expected edges that fit, found `close` (Complete job) behind `move` (Joint job), at step 1 of flow 0",
    ]


def test_a_target_of_other_edges_does_not_fit() -> None:
    other = icon("pose", "Cartesian object")
    assert result((MOVE, other)) == [
        "expected edges that fit, found `pose` (Cartesian object) behind `move` (Joint job), at step 1 of flow 0"
    ]


def test_the_first_and_the_last_icon_must_fit_start_and_end() -> None:
    assert "expected edges that fit, found Application end behind `move` (Joint job), at step 1 of flow 0" in result(
        (MOVE,)
    )


def test_a_missing_task_is_named() -> None:
    assert result((MOVE, THERE), tasks={}) == ["expected the task jmove, found none for `move`, step 0 of flow 0"]


def test_a_configuration_without_tasks_is_named() -> None:
    assert result((CLOSE,), configurations={"close": conf("close")}) == [
        "expected tasks, found none in `close`, step 0 of flow 0"
    ]


def test_conflicts_within_a_configuration_are_named() -> None:
    tasks = {**TASKS, "hold": Task("hold", "hold", outvar=("GRIP",))}  # reading 1
    (fault,) = result((CLOSE,), configurations={"close": conf("close", "grip", "hold")}, tasks=tasks)
    assert fault == (
        "expected tasks that may stand together"
        ", found `hold` in `close`, step 0 of flow 0: writes GRIP, which `grip` already writes"
    )


def test_conflicts_in_the_union_of_a_flow_are_named_but_not_across_flows() -> None:
    tasks = {**TASKS, "other": Task("other", "grip")}  # reading 1, law 9
    configurations = {**CONFIGURATIONS, "open": conf("open", "other")}
    opened = icon("open", "Complete job")
    expected = (
        "expected every module once in a flow"
        ", found grip in `grip` (in `close`, step 0) and `other` (in `open`, step 1) of flow 0"
    )
    assert result((CLOSE, opened), configurations=configurations, tasks=tasks) == [expected]
    assert result((CLOSE,), (opened,), configurations=configurations, tasks=tasks) == []


def test_a_trigger_changed_after_the_job_was_made_is_found() -> None:
    tasks = {"jmove": Task("jmove", "jmove", object_type="Cartesian job")}  # reading 36
    expected = "expected a Cartesian job, as its trigger `jmove` says, found Joint job for `move`, step 0 of flow 0"
    assert result((MOVE, THERE), tasks=tasks) == [expected]
    without = {"jmove": Task("jmove", "jmove")}
    assert result((MOVE, THERE), tasks=without) == [
        "expected a task with OBJECT Joint job in `move`, found none at `move`, step 0 of flow 0"
    ]


def test_a_job_of_unknown_type_acts_as_a_complete_one() -> None:
    assert result((icon("close", "Force job"),)) == []  # R-D16
    assert result((icon("move", "Force job"),)) == []


def test_malformed_loops_are_named() -> None:
    looped = Icon(CLOSE.onikon, while_tag="a", while_test=True)
    assert result((looped, CLOSE)) == [
        "expected the loop tag a twice in flow 0, found 1 times, last at `close`, step 0"
    ]


PART = icon("part", "Complete application")


def test_nested_applications_are_checked_with_their_contents() -> None:
    part = Application("part", False, (AppFlow((icon("lost", "Complete job"), Hole())),))  # R-E06
    assert result((PART,), applications={}) == [
        "expected the application part, found none for `part`, step 0 of flow 0"
    ]
    assert result((PART,), applications={"part": part}) == [
        "expected an action in place of a hole, found a hole, step 1 of flow 0 of `part`",
        "expected the configuration lost, found none for `lost`, step 0 of flow 0 of `part`",
    ]


def test_a_target_fills_the_holes_of_a_nested_application() -> None:
    part = Application("part", False, (AppFlow((MOVE, Hole(), CLOSE)),))  # R-D09
    assert result((icon("part", "Joint application"), THERE), applications={"part": part}) == []


def test_recursion_is_refused_naming_the_cycle() -> None:
    part = Application("part", False, (AppFlow((icon("work", "Complete application"),)),))  # R-E06
    (fault,) = result((PART,), applications={"part": part})
    assert fault.startswith("expected no application within itself, found work in part in work, at `work`")


def test_where_no_application_is_given_a_nested_one_is_missed() -> None:
    assert result((PART,)) == ["expected the application part, found none for `part`, step 0 of flow 0"]  # R-E06


def test_a_fault_of_a_nested_application_names_its_own_file() -> None:
    part = Application("part", False, (AppFlow((Hole(),)),))  # R-E01
    application = Application("work", False, (AppFlow((PART,)),))
    given = faults(
        application, SYNTAX, {}, {}, PLACE, applications={"part": part}, files={"part": "lab/appl/part.appl"}
    )
    assert {fault.place.file for fault in given} == {"lab/appl/part.appl"}


def test_a_target_that_a_nested_application_needs_is_missed_where_it_stands() -> None:
    part = Application("part", False, (AppFlow((MOVE, Hole())),))  # R-D09
    assert result((PART,), applications={"part": part}) == [
        "expected a Joint object for the holes of `part`, found none behind `part`, step 0 of flow 0"
    ]


def test_a_loop_that_takes_no_time_is_named() -> None:
    begin = Icon(NOP.onikon, while_tag="a")  # R-E05
    end = Icon(NOP.onikon, while_tag="a", while_test=True)
    (fault,) = result((begin, end))
    assert fault.startswith("expected a job on every way round the loop a")


def test_a_tag_that_stands_alone_is_named() -> None:
    tagged = Icon(CLOSE.onikon, synch_tag="meet")  # R-E04
    (fault,) = result((tagged,), (CLOSE,))
    assert "meet" in fault


def test_a_configuration_of_two_flows_is_judged_where_it_stands_first() -> None:
    assert result((CLOSE,), (NOP, CLOSE), configurations={"close": conf("close")}) == [
        "expected tasks, found none in `close`, step 0 of flow 0"
    ]


def test_what_is_nested_too_deep_is_not_looked_at_in_line() -> None:
    applications = {  # R-E06
        f"part{k}": Application(f"part{k}", False, (AppFlow((icon(f"part{k + 1}", "Complete application"),)),))
        for k in range(100)
    }
    applications["part100"] = Application("part100", False, (AppFlow((CLOSE,)),))
    deep = (icon("part0", "Complete application"),)
    (fault,) = result(deep, configurations={"close": conf("close")}, applications=applications)
    assert "100" in fault
    shallow = (icon("part2", "Complete application"),)
    wrong = result(shallow, configurations={"close": conf("close")}, applications=applications)
    assert "tasks" in wrong[-1]


def test_a_task_that_stands_for_another_is_judged_in_its_place() -> None:
    application = Application("work", False, (AppFlow((CLOSE,)),))  # R-E09
    tasks = {**TASKS, "other": Task("other", "other", outvar=("LAMP",))}
    configurations = {"close": conf("close", "grip", "other")}
    assert faults(application, SYNTAX, configurations, tasks, PLACE) == ()
    clashing = {**tasks, "double": Task("double", "double", outvar=("LAMP",))}
    given = faults(application, SYNTAX, configurations, clashing, PLACE, redirects=(Redirect("grip", "double"),))
    assert any("LAMP" in f"{fault.reason}" for fault in given)
