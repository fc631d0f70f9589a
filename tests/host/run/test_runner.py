import pytest

from kit.plans.plan_builder import action
from kit.runtime.runner_rig import NotingUnits, RunnerRig
from onika.runtime import command, news
from onika.wire import event, steer
from onika.wire.request import Begin
from onika.words.reason import NOTHING, Reason

BOTH = [action("arm", "go", arguments="")]


def switches(rig):
    return [
        (rtpu, order.off, tuple(launch.task for launch in order.on)) for rtpu, order in rig.units.take(command.Switch)
    ]


def test_tasks_are_spawned_as_soon_as_their_constants_are_there():  # law 10
    rig = RunnerRig(BOTH).start()
    assert [(rtpu, order.task) for rtpu, order in rig.units.take(command.Spawn)] == [("rt0", "arm")]
    rig.spawned("arm")
    assert [(rtpu, order.task) for rtpu, order in rig.units.take(command.Spawn)] == [("rt1", "go")]
    assert rig.units.granted == [("rt0", "yard:m0")]


def test_nothing_is_switched_on_before_everything_lives():  # R-E02
    rig = RunnerRig(BOTH).start().spawned("arm")
    assert switches(rig) == []
    rig.spawned("go")
    assert len(switches(rig)) == 1


def test_units_are_switched_one_after_the_other_so_that_the_order_of_on_holds():  # reading 14, law 2
    rig = RunnerRig([action("arm", "go", "show")]).start().spawned("arm", "go", "show")
    order = []
    while sent := switches(rig):
        ((rtpu, off, on),) = sent
        order += [(rtpu, name) for name in on]
        assert off == ()
        rig.turned_on(*on)
    assert {name: rtpu for rtpu, name in order} == {"arm": "rt0", "go": "rt1", "show": "rt0"}
    assert [name for _, name in order].index("arm") == 0


def test_a_group_goes_out_only_when_the_one_before_it_is_on():  # reading 14
    rig = RunnerRig(BOTH).start().spawned("arm", "go")
    assert switches(rig) == [("rt0", (), ("arm",))]
    assert switches(rig) == []
    rig.turned_on("arm")
    assert switches(rig) == [("rt1", (), ("go",))]


def test_a_task_that_fails_or_asks_at_on_holds_up_nobody():  # law 25
    rig = RunnerRig(BOTH).start().spawned("arm", "go")
    switches(rig)
    rig.hear(news.Asked("flow0", "arm", NOTHING, (), rig.now))
    assert rig.runner.is_asking
    assert rig.units.take(command.Kill)  # nobody is there to answer


def test_when_the_last_trigger_has_finished_things_settle_are_read_and_reported():  # R-E03, R-E14
    rig = (
        RunnerRig([action("bell")], begin=Begin(watch=("X",), settle_s=0.25)).start().spawned("bell").turned_on("bell")
    )
    rig.finish("bell")
    assert rig.runner.wake_at() == rig.now + 250_000_000
    rig.runner.tick(rig.now + 249_999_999)
    assert rig.units.take(command.Report) == []
    rig.runner.tick(rig.now + 250_000_000)
    assert [rtpu for rtpu, _ in rig.units.take(command.Report)] == ["rt0"]
    assert not rig.runner.is_over
    rig.hear(news.Statuses("rt0", 0.0, ()))
    assert [order.task for _, order in rig.units.take(command.Kill)] == ["bell"]
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert rig.runner.is_over
    assert (rig.runner.statistics.completed, rig.runner.statistics.done) == (True, 1)


def test_the_watcher_is_told_states_actions_and_times_since_the_run_began():  # R-E11
    rig = RunnerRig([action("bell"), action("bell")]).start().spawned("bell").turned_on("bell")
    rig.now += 2_000_000_000
    rig.finish("bell")
    assert [(message.index, message.of, message.action, message.at_s) for message in rig.of(event.Began)] == [
        (0, 2, "action 0", 0.0),
        (1, 2, "action 1", 2.0),
    ]
    assert [(message.index, message.at_s) for message in rig.of(event.Done)] == [(0, 2.0)]
    assert [message.state for message in rig.of(event.TaskState)] == ["OFF", "ON", "OFF"]


def test_an_abort_kills_every_task_and_names_the_cause():  # R-E14
    rig = RunnerRig(BOTH).start().spawned("arm", "go")
    rig.runner.abort(Reason.plain("enough"), rig.now)
    assert sorted(order.task for _, order in rig.units.take(command.Kill)) == ["arm", "go"]
    for name in ("arm", "go"):
        assert not rig.runner.is_over
        rig.hear(news.Changed("flow0", name, "KILLED", rig.now))
    assert rig.runner.is_over
    assert (rig.runner.statistics.completed, str(rig.runner.statistics.cause)) == (False, "enough")
    assert rig.units.released == ["yard:m0"]


def test_an_abort_before_a_task_was_sent_kills_it_on_paper():  # law 10
    rig = RunnerRig(BOTH).start()
    rig.runner.abort(Reason.plain("enough"), rig.now)
    assert [order.task for _, order in rig.units.take(command.Kill)] == ["arm"]
    rig.hear(news.Changed("flow0", "arm", "KILLED", rig.now))
    assert rig.runner.is_over


def test_an_abort_is_told_with_its_time():  # R-E14
    rig = RunnerRig(BOTH).start()  # the arm's constant is not there: `go` ends on paper, at once
    rig.runner.abort(Reason.plain("enough"), rig.now + 2_000_000_000)
    assert [(change.task, change.state, change.at_s) for change in rig.of(event.TaskState)] == [("go", "KILLED", 2.0)]


def test_after_an_abort_nobody_waits_for_a_switch_that_was_prepared():  # R-E14
    rig = RunnerRig([action("bell"), action("bell", "show")]).start().spawned("bell", "show").turned_on("bell")
    assert rig.units.take(command.PreparedSwitch)
    answers = []
    rig.runner.steer(steer.Skip("flow0", 1), rig.now, answers.append)
    assert answers == []  # the unit has not said yet that nothing is prepared any more
    rig.runner.abort(Reason.plain("enough"), rig.now)
    assert len(answers) == 1 and answers[0]


def test_a_second_abort_changes_nothing():
    rig = RunnerRig([action("bell")]).start().spawned("bell")
    rig.runner.abort(Reason.plain("first"), rig.now)
    rig.runner.abort(Reason.plain("second"), rig.now)
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    rig.runner.abort(Reason.plain("third"), rig.now)
    assert str(rig.runner.statistics.cause) == "first"
    assert len(rig.units.take(command.Kill)) == 1


def test_an_abort_while_things_settle_ends_the_run_as_aborted():  # R-E14
    rig = RunnerRig([action("bell")]).start().spawned("bell").turned_on("bell").finish("bell")
    rig.runner.abort(Reason.plain("enough"), rig.now)
    assert rig.runner.wake_at() is None
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert not rig.runner.statistics.completed


def test_a_task_in_error_ends_the_run_and_is_told_with_its_line():  # R-A09, R-E08
    rig = RunnerRig([action("bell")]).start().spawned("bell").turned_on("bell")
    rig.hear(news.Failed("flow0", "bell", "cycle", Reason.plain("ValueError: no"), "bell.py", 7, "trace", rig.now))
    (failed,) = rig.of(event.Failed)
    assert (str(failed.text), failed.path, failed.line) == ("cycle: ValueError: no", "bell.py", 7)
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert str(rig.runner.statistics.cause) == (
        "test.appl:1 (action 0): bell is in error: cycle: ValueError: no (bell.py:7)"
    )


def test_a_passive_task_in_error_is_noted_and_the_job_goes_on():  # reading 17
    rig = RunnerRig([action("bell", "show")]).start().spawned("bell", "show").turned_on("bell", "show")
    rig.hear(news.Failed("flow0", "show", "cycle", Reason.plain("ValueError: no"), "show.py", 7, "", rig.now))
    assert rig.units.take(command.Kill) == []
    assert any(message.text.key == "engine.passive_in_error" for message in rig.of(event.Warned))
    rig.finish("bell")
    assert rig.runner.wake_at() is not None


def test_a_device_that_cannot_be_claimed_ends_the_run_with_the_reason():  # law 16
    units = NotingUnits()
    units.refuses = "expected a device of world yard (m0), found 'm7'"
    rig = RunnerRig(BOTH, units=units).start()
    assert rig.runner.is_over
    assert "found 'm7'" in str(rig.runner.statistics.cause)


def test_a_lost_unit_takes_its_tasks_with_it():  # R-E10
    rig = RunnerRig(BOTH).start().spawned("arm", "go")
    rig.runner.abort(Reason.plain("processing unit rt0 is gone"), rig.now)
    rig.runner.lost("rt0", Reason.plain("rt0 was killed"), rig.now)
    assert not rig.runner.is_over
    rig.hear(news.Changed("flow0", "go", "KILLED", rig.now), "rt1")
    assert rig.runner.is_over
    assert rig.units.released == ["yard:m0"]


def test_a_lost_unit_is_not_waited_for_when_statuses_are_asked():  # R-E10
    rig = RunnerRig([action("arm", "go")]).start().spawned("arm", "go").turned_on("arm", "go").finish("go")
    rig.runner.tick(rig.now + 500_000_000)
    assert sorted(rtpu for rtpu, _ in rig.units.take(command.Report)) == ["rt0", "rt1"]
    rig.runner.abort(Reason.plain("rt0 is gone"), rig.now)
    rig.runner.lost("rt0", Reason.plain("rt0 was killed"), rig.now)
    rig.hear(news.Changed("flow0", "go", "KILLED", rig.now), "rt1")
    assert rig.runner.is_over


def test_a_run_of_no_ops_alone_ends():  # R-E14
    rig = RunnerRig([action()]).start()
    assert not rig.runner.is_over
    rig.runner.tick(rig.now + 500_000_000)
    assert rig.runner.is_over
    assert rig.runner.statistics.done == 1


def test_news_of_unknown_tasks_is_nobodys():
    rig = RunnerRig([action("bell")]).start()
    before = list(rig.events)
    for report in (news.Initialised("flow9", "bell"), news.Finished("flow0", "nobody", 0, False, 0)):
        rig.hear(report)
    assert rig.events == before


@pytest.mark.parametrize("kind", ["ILLEGAL", "SHUTDOWN"])
def test_a_task_that_may_not_go_on_ends_the_run(kind):  # R-A08
    rig = RunnerRig([action("bell")]).start().spawned("bell").turned_on("bell")
    rig.hear(news.Signalled("flow0", "bell", kind, 0, Reason.plain("too hot"), rig.now))
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert f"{kind}: too hot" in str(rig.runner.statistics.cause)


def test_signals_that_end_nothing_change_nothing():  # R-A08
    rig = RunnerRig([action("bell")]).start().spawned("bell").turned_on("bell")
    rig.hear(news.Signalled("flow0", "bell", "LEGAL", 0, NOTHING, rig.now))
    rig.hear(news.Warned("flow0", "bell", Reason.plain("warm"), rig.now))
    assert rig.units.take(command.Kill) == []
    assert str(rig.of(event.Warned)[-1].text) == "warm"


def test_two_flows_begin_and_end_together_on_their_own_subsystems():  # R-E04, R-E14
    rig = RunnerRig([action("bell")], [action("show", "bell")]).start()
    assert {order.subsystem for _, order in rig.units.take(command.Spawn)} == {"flow0", "flow1"}
    rig.spawned("bell").spawned("show", "bell", subsystem="flow1")
    rig.turned_on("bell").turned_on("show", "bell", subsystem="flow1")
    rig.finish("bell")
    assert rig.runner.wake_at() is None
    rig.finish("bell", "flow1")
    assert rig.runner.wake_at() is not None


def test_flows_that_meet_begin_by_one_command_where_they_share_a_unit():  # R-E04
    rig = RunnerRig([action("bell")], [action("bell")]).start()
    rig.spawned("bell").spawned("bell", subsystem="flow1")
    (together,) = [order for _, order in rig.units.take(command.Together)]
    assert [(switch.subsystem, [launch.task for launch in switch.on]) for switch in together.switches] == [
        ("flow0", ["bell"]),
        ("flow1", ["bell"]),
    ]


def test_the_switch_that_was_prepared_is_not_sent_again():
    rig = RunnerRig([action("bell"), action("bell", "show")]).start().spawned("bell", "show").turned_on("bell")
    ((_, prepared),) = rig.units.take(command.PreparedSwitch)
    assert [task.task for task in prepared.cases[0].switch.on] == ["bell", "show"]
    rig.units.take(command.Switch)
    rig.hear(news.Finished("flow0", "bell", 0, False, rig.now, prepared.activation, 1))
    assert rig.units.take(command.Switch) == []
    assert [(message.index, message.action) for message in rig.of(event.Began)][-1][0] == 1
    late = prepared.activation  # a word about the activation before says nothing any more
    rig.hear(news.Finished("flow0", "bell", 0, False, rig.now, late, 0))
    assert len(rig.of(event.Done)) == 1


def test_a_failed_task_is_cleared_and_the_step_repeated_where_somebody_decides():  # R-E08
    rig = RunnerRig([action("bell", "arm", "go")], begin=Begin(on_error="wait")).start()
    rig.spawned("arm", "bell", "go").turned_on("bell", "arm", "go")
    rig.units.sent.clear()
    rig.hear(news.Failed("flow0", "arm", "cycle", Reason.plain("panic"), "", 0, "", rig.now))
    assert ("bell",) in [order.off for _, order in rig.units.take(command.Switch)]  # its trigger waits for nobody
    answers = []
    rig.runner.steer(steer.Recover("flow0"), rig.now, answers.append)
    assert not answers[0]
    assert [order.task for _, order in rig.units.take(command.Clear)] == ["arm"]
    rig.hear(news.Changed("flow0", "arm", "OFF", rig.now))
    ons = [launch.task for _, order in rig.units.take(command.Switch) for launch in order.on]
    assert "arm" in ons
    assert [message.state for message in rig.of(event.Moved)] == ["stopped", "clearing", "running"]


def test_a_failure_counts_however_late_it_is_heard():  # R-E08
    rig = (
        RunnerRig([action("bell"), action("bell")], begin=Begin(on_error="wait"))
        .start()
        .spawned("bell")
        .turned_on("bell")
    )
    ((_, prepared),) = rig.units.take(command.PreparedSwitch)
    rig.runner.steer(steer.Skip("flow0", 1), rig.now, lambda _refusal: None)
    rig.hear(news.Unprepared("flow0"))
    rig.hear(news.Failed("flow0", "bell", "off", Reason.plain("no"), "", 0, "", rig.now, prepared.activation))
    assert [message.state for message in rig.of(event.Moved)][-1] == "stopped"
    rig.runner.steer(steer.Recover("flow0"), rig.now, lambda _refusal: None)
    assert [order.task for _, order in rig.units.take(command.Clear)] == ["bell"]


def ending():
    """A run whose last action is done, and whose task is being ended."""
    rig = RunnerRig([action("bell")], begin=Begin(settle_s=0.0)).start().spawned("bell").turned_on("bell")
    rig.finish("bell")
    rig.runner.tick(rig.now)
    rig.hear(news.Statuses("rt0", 0.0, ()))
    assert rig.units.take(command.Kill)
    return rig


def remarks(rig):
    result = rig.runner.statistics.result(1, 0.0, "")
    assert result.completed
    assert [message.text for message in rig.of(event.Warned)] == list(result.remarks)
    return list(map(str, result.remarks))


def test_a_task_that_fails_as_it_is_ended_is_named_at_the_end_of_a_completed_run():  # R-E14
    rig = ending()
    rig.hear(news.Failed("flow0", "bell", "kill", Reason.plain("SystemExit: 4"), "", 0, "", rig.now))
    rig.hear(news.Changed("flow0", "bell", "KILLED", rig.now))
    assert remarks(rig) == [
        "all actions are done, but while the tasks were ended: task flow0/bell failed in kill: SystemExit: 4"
    ]


def test_a_unit_that_is_lost_while_the_tasks_are_ended_is_named_at_the_end_of_a_completed_run():  # R-E10, R-E14
    rig = ending()
    rig.runner.lost("rt0", Reason.plain("rt0 is gone"), rig.now)
    assert remarks(rig) == ["all actions are done, but while the tasks were ended: rt0 is gone"]


def test_a_run_that_ends_well_or_badly_has_no_remarks():  # R-E14
    well = ending().hear(news.Changed("flow0", "bell", "KILLED", 1_000))
    assert remarks(well) == []
    badly = RunnerRig([action("bell")]).start().spawned("bell").turned_on("bell")
    badly.runner.lost("rt0", Reason.plain("rt0 is gone"), badly.now)
    assert badly.runner.statistics.result(1, 0.0, "").remarks == ()
