from dataclasses import replace

from onika.desk.plan.compile import planned_task
from onika.model.planned import task_of
from onika.model.task import LocalLine, Task, TaskType

TASK = Task(
    "t",
    "m",
    aliases=(("Y", "Q"),),
    inconst=("KP",),
    outconst=("N",),
    invar=("R",),
    outvar=("Y",),
    type=TaskType.SYNCHRONOUS,
    frequency=5.0,
    local=(LocalLine("SPEED", ("0.5", "1")),),
)


def test_a_task_that_travelled_with_a_plan_is_what_it_was():
    assert task_of(planned_task(TASK, "rt0", "digest", "t.rmod")) == TASK


def test_what_only_the_canvas_needs_does_not_travel():
    drawn = replace(TASK, description="words", object_type="Joint job")
    assert task_of(planned_task(drawn, "rt0", "digest", "t.rmod")) == TASK
