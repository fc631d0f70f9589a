from kit.plans import build
from onika.engine.flow_tasks import FlowTasks
from onika.engine.orders import Kill, Launch, Off, Spawn, Switch
from onika.engine.step import steps

REACH = build.job("move", "puma", trigger="move", arguments="1 2")
GRASP = build.job("grip", "puma", trigger="grip")


def flow_tasks(*jobs, others=(), ranks=None):
    """The tasks of these jobs, spawned, and its steps."""
    planned = build.plan(jobs).flows[0]
    ranks = ranks or {name: place for place, name in enumerate(build.names(jobs))}
    triggers = {index: job.trigger for index, job in enumerate(jobs)}
    made = FlowTasks(0, planned, ranks)
    made.spawn()
    return made, steps(planned, triggers, set(others), ranks)


def switch(made, step):
    """Switch to a step, in which all come ON."""
    change = made.change(step)
    made.carry_out(step, change)
    for start in change.on:
        made.turned_on(start.task)
    return change


def on(*tasks, ranks="1 2"):
    return tuple(Launch(task, ranks if task == "move" else "", 100.0) for task in tasks)


def test_spawning_orders_the_union_of_the_tasks_once_each():  # R-E02
    made, _ = flow_tasks(REACH, GRASP, REACH)
    assert made.spawn() == [Spawn(0, "move"), Spawn(0, "puma"), Spawn(0, "grip")]


def test_the_tasks_of_a_flow_are_spawned_when_no_task_is_awaited():
    made, _ = flow_tasks(REACH)
    made.spawned("puma")
    assert not made.is_spawned
    assert made.is_unborn("move")
    assert not made.is_unborn("puma")
    made.spawned("move")
    assert made.is_spawned


def test_the_first_action_turns_all_its_tasks_on():
    made, (reach,) = flow_tasks(REACH)
    assert made.change(reach) == Switch(0, (), on("move", "puma"))


def test_asking_what_would_change_changes_nothing():
    made, (reach,) = flow_tasks(REACH)
    assert made.change(reach) == made.change(reach)


def test_the_next_action_leaves_common_tasks_alone():  # R-E02, law 6
    made, (reach, grasp) = flow_tasks(REACH, GRASP)
    switch(made, reach)
    assert made.switched_off("move")
    assert made.change(grasp) == Switch(0, (), on("grip"))


def test_a_change_can_be_foreseen_as_if_the_trigger_had_finished():
    made, (reach, grasp) = flow_tasks(REACH, GRASP)
    switch(made, reach)
    assert made.change(grasp) == Switch(0, ("move",), on("grip"))
    assert made.change(grasp, finished="move") == Switch(0, (), on("grip"))
    assert made.change(grasp, number=4).number == 4


def test_a_trigger_that_is_still_on_is_turned_off_and_on_again():
    jobs = build.job("a", "b", trigger="a"), build.job("b", trigger="b", arguments="7")
    made, (first, second) = flow_tasks(*jobs, others=["b"])
    switch(made, first)
    made.switched_off("a")
    change = made.change(second)
    assert change == Switch(0, ("b",), (Launch("b", "7", 100.0),))
    made.carry_out(second, change)
    assert not made.switched_off("b")


def test_a_task_that_is_kept_before_it_has_said_that_it_is_on_is_still_awaited():
    made, (reach, grasp) = flow_tasks(REACH, GRASP)
    made.carry_out(reach, made.change(reach))
    switch(made, grasp)
    assert not made.is_settled
    assert not made.switched_off("puma")


def test_a_kept_task_gets_the_rate_of_the_new_action_and_its_own_back_after_it():  # reading 13
    made, (reach, slow, again) = flow_tasks(
        REACH, build.job("grip", "puma", trigger="grip", rates={"puma": 50.0}), REACH
    )
    switch(made, reach)
    assert switch(made, slow).kept_rates == (("puma", 50.0),)
    assert switch(made, again).kept_rates == (("puma", 100.0),)


def test_the_tasks_of_a_flow_are_settled_when_all_that_were_to_come_on_have_said_so():
    made, (reach, _) = flow_tasks(REACH, GRASP)
    made.carry_out(reach, made.change(reach))
    made.turned_on("move")
    assert not made.is_settled
    made.turned_on("puma")
    assert made.is_settled


def test_a_task_that_went_off_comes_on_with_the_next_action_that_needs_it():
    made, (reach, grasp) = flow_tasks(REACH, GRASP)
    switch(made, reach)
    assert made.switched_off("puma")
    assert [start.task for start in made.change(grasp).on] == ["puma", "grip"]


def test_a_task_that_was_kept_on_is_believed_when_it_goes_off():
    made, (first, second) = flow_tasks(*[build.job("a", "see", trigger="a")] * 2)
    switch(made, first)
    made.switched_off("a")
    switch(made, second)
    assert made.switched_off("see")


def test_late_word_of_a_task_that_went_off_before_it_came_on_again_is_not_believed():
    made, (reach,) = flow_tasks(REACH)
    switch(made, reach)
    made.rest(("puma",))
    made.carry_out(reach, made.change(reach))
    assert not made.switched_off("puma")
    made.turned_on("puma")
    assert made.switched_off("puma")


def test_late_word_of_a_task_that_is_to_be_off_says_nothing():
    made, (_, grasp) = flow_tasks(REACH, GRASP)
    switch(made, grasp)
    made.turned_on("move")
    assert not made.switched_off("move")


def test_only_what_is_on_rests():
    made, (reach, _) = flow_tasks(REACH, GRASP)
    switch(made, reach)
    assert made.rest(("move", "grip")) == [Off(0, "move")]
    assert made.rest(("move",)) == []


def test_a_task_that_was_given_up_stays_off():  # reading 17
    made, (reach,) = flow_tasks(REACH)
    switch(made, reach)
    made.given_up("puma")
    made.rest(("move",))
    assert made.change(reach) == Switch(0, (), on("move"))


def test_a_task_that_is_given_up_before_it_lives_is_not_awaited():  # reading 17
    made, _ = flow_tasks(REACH)
    made.spawned("move")
    made.given_up("puma")
    assert made.is_spawned
    assert made.lives("puma")


def test_a_task_that_was_on_when_it_failed_is_brought_back():  # R-E08
    made, (reach,) = flow_tasks(REACH)
    switch(made, reach)
    made.has_failed("puma")
    assert (made.failed, made.in_error) == ({"puma": True}, {"puma"})
    assert made.bring_back(reach) == [Switch(0, (), on("puma"))]
    assert made.failed == {}
    assert made.bring_back(reach) == []


def test_a_task_that_was_brought_back_is_believed_once_it_has_said_that_it_is_on():  # R-E08
    made, (reach,) = flow_tasks(REACH)
    switch(made, reach)
    made.has_failed("puma")
    made.bring_back(reach)
    assert not made.is_settled
    assert not made.switched_off("puma")
    made.turned_on("puma")
    assert made.is_settled
    assert made.switched_off("puma")


def test_a_task_that_fails_twice_has_been_on():  # R-E08
    made, (reach,) = flow_tasks(REACH)
    switch(made, reach)
    made.has_failed("puma")
    made.has_failed("puma")
    assert made.bring_back(reach) == [Switch(0, (), on("puma"))]


def test_neither_a_trigger_nor_who_was_off_nor_anybody_before_the_first_action_is_brought_back():  # R-E08
    made, (reach, _) = flow_tasks(REACH, GRASP)
    made.has_failed("puma")
    assert made.bring_back(None) == []
    switch(made, reach)
    made.has_failed("move")
    made.has_failed("grip")
    assert made.bring_back(reach) == []


def test_what_failed_together_is_brought_back_in_the_order_of_ranks():  # law 1
    job = build.job("move", "pd", "puma", trigger="move")
    made, (step,) = flow_tasks(job, ranks={"puma": 0, "move": 1, "pd": 2})
    switch(made, step)
    for task in ("pd", "puma"):
        made.has_failed(task)
    (back,) = made.bring_back(step)
    assert [start.task for start in back.on] == ["puma", "pd"]


def test_a_task_that_would_not_come_on_comes_with_the_next_switch():
    made, (reach,) = flow_tasks(REACH)
    switch(made, reach)
    made.would_not("move")
    assert made.change(reach) == Switch(0, (), on("move"))


def test_all_living_tasks_are_killed_in_the_order_of_their_ranks():
    made, _ = flow_tasks(REACH, GRASP, ranks={"puma": 0, "move": 1, "grip": 2})
    made.gone("move")
    assert not made.lives("move")
    assert made.kill() == [Kill(0, "puma"), Kill(0, "grip")]


def test_the_tasks_of_a_flow_are_gone_with_its_last_task():
    made, _ = flow_tasks(REACH)
    made.gone("move")
    assert not made.is_gone
    made.gone("puma")
    assert made.is_gone


def test_a_task_is_found_in_its_file():
    assert flow_tasks(REACH)[0].place("puma") == "puma.rmod"
