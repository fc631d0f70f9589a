from onika.desk.run.script_player import ScriptPlayer
from onika.desk.run.steering_script import read
from onika.wire import event, request, steer
from onika.words.reason import NOTHING, Reason

BEGAN = event.Began(0, 0, 2, "jmoveC aside", 1.0)
GOOD = event.Result(True, NOTHING, 4, 4, 9.0, 0.1, {}, (), "abc")


def player_of(run, text):
    """A player of this script, and what it tells."""
    output = []
    script_lines, faults = read(text, "s", run.flow_index)
    assert faults == []
    return ScriptPlayer(
        run, script_lines, lambda line, faults, where: output.append((line, [str(f) for f in faults], where))
    ), output


def to_the_end(run, player):
    while not run.is_over:
        list(run.hear())
        while player.go_on():
            pass
        run.go_on(player.until_s)
    while player.go_on():
        pass


def test_lines_are_carried_out_one_after_another_at_their_moments(running):  # R-E07
    run, runtime = running(BEGAN, GOOD)
    player, output = player_of(run, "pause\nwait began 0 1\nwait 0.5\ncontinue\n")
    to_the_end(run, player)
    assert [line for line, _, _ in output] == ["pause", "wait began 0 1", "wait 0.5", "continue"]
    assert player.is_over
    assert runtime.of(steer.Pause, steer.Resume) == [steer.Pause(""), steer.Resume("")]
    assert steer.Onward(1.5) in runtime.requests


def test_nothing_is_done_while_the_clock_of_a_held_run_goes_on(running):  # R-E07
    run, runtime = running(BEGAN)
    player, output = player_of(run, "pause\n")
    assert not player.go_on()
    assert runtime.of(steer.Pause) == output == []
    list(run.hear())
    assert player.go_on()


def test_nothing_is_done_while_a_task_asks(running):  # law 25
    run, runtime = running(is_held=False)
    run.flow_tracker.hear(event.Asked("flow0", "gauge", NOTHING, (), 0.5))
    player, _ = player_of(run, "pause\n")
    assert not player.go_on()
    assert runtime.of(steer.Pause) == []


def test_who_is_told_with_the_positions(running):  # R-X03
    run, runtime = running(GOOD)
    runtime.positions = (steer.Position("flow0", "running", 0),)
    player, output = player_of(run, "who\n")
    to_the_end(run, player)
    assert output == [("who", [], runtime.positions)]


def test_the_first_line_that_fails_ends_the_script_and_the_run(running):  # R-E07
    run, runtime = running(BEGAN, GOOD)
    player, output = player_of(run, "# a comment\nexpect LAMP == 0\npause\n")
    to_the_end(run, player)
    assert [line for line, _, _ in output] == ["expect LAMP == 0"]
    assert runtime.of(request.Abort) == [request.Abort(Reason.of("desk.script_fails", place="s:2"))]
    assert [str(run.place) for run in run.outcome.failed] == ["s:2"]
    assert runtime.of(steer.Pause) == []


def test_lines_left_after_a_good_end_fail_without_an_abort(running):  # R-E07
    run, runtime = running(GOOD)
    player, output = player_of(run, "wait began 0 1\npause\n")
    to_the_end(run, player)
    assert len(output) == len(run.outcome.failed) == 1
    assert runtime.of(request.Abort) == []


def test_lines_left_after_an_abort_are_left_alone(running):  # R-E07
    run, _ = running(event.Result(False, Reason.plain("stopped"), 0, 4, 1.0, 0.1, {}, (), ""))
    player, output = player_of(run, "wait began 0 1\npause\n")
    to_the_end(run, player)
    assert (output, run.outcome.failed, player.is_over) == ([], (), True)
