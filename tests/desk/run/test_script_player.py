from onika.desk.run.script_player import Prompter
from onika.desk.run.steering_script import read
from onika.wire import event, request, steer

BEGAN = event.Began(0, 0, 2, "jmoveC aside", 1.0)
GOOD = event.Result(True, "", 4, 4, 9.0, 0.1, {}, (), "abc")


def prompted(run, text):
    """A prompter of this script, and what it tells."""
    output = []
    cues, faults = read(text, "s", run.cast)
    assert faults == []
    return Prompter(
        run, cues, lambda line, faults, where: output.append((line, [str(f) for f in faults], where))
    ), output


def to_the_end(run, prompter):
    while not run.is_over:
        list(run.hear())
        while prompter.go_on():
            pass
        run.go_on(prompter.until_s)
    while prompter.go_on():
        pass


def test_lines_are_carried_out_one_after_another_at_their_moments(running):  # R-E07
    run, runtime = running(BEGAN, GOOD)
    prompter, output = prompted(run, "pause\nwait began 0 1\nwait 0.5\ncontinue\n")
    to_the_end(run, prompter)
    assert [line for line, _, _ in output] == ["pause", "wait began 0 1", "wait 0.5", "continue"]
    assert prompter.is_over
    assert runtime.of(steer.Pause, steer.Resume) == [steer.Pause(""), steer.Resume("")]
    assert steer.Onward(1.5) in runtime.requests


def test_nothing_is_done_while_the_clock_of_a_held_run_goes_on(running):  # R-E07
    run, runtime = running(BEGAN)
    prompter, output = prompted(run, "pause\n")
    assert not prompter.go_on()
    assert runtime.of(steer.Pause) == output == []
    list(run.hear())
    assert prompter.go_on()


def test_nothing_is_done_while_a_task_asks(running):  # law 25
    run, runtime = running(is_held=False)
    run.whereabouts.hear(event.Asked("flow0", "gauge", "", (), 0.5))
    prompter, _ = prompted(run, "pause\n")
    assert not prompter.go_on()
    assert runtime.of(steer.Pause) == []


def test_who_is_told_with_the_positions(running):  # R-X03
    run, runtime = running(GOOD)
    runtime.positions = (steer.Position("flow0", "running", 0),)
    prompter, output = prompted(run, "who\n")
    to_the_end(run, prompter)
    assert output == [("who", [], runtime.positions)]


def test_the_first_line_that_fails_ends_the_script_and_the_run(running):  # R-E07
    run, runtime = running(BEGAN, GOOD)
    prompter, output = prompted(run, "# a comment\nexpect LAMP == 0\npause\n")
    to_the_end(run, prompter)
    assert [line for line, _, _ in output] == ["expect LAMP == 0"]
    assert runtime.of(request.Abort) == [request.Abort("the script fails at s:2")]
    assert [str(run.place) for run in run.outcome.failed] == ["s:2"]
    assert runtime.of(steer.Pause) == []


def test_lines_left_after_a_good_end_fail_without_an_abort(running):  # R-E07
    run, runtime = running(GOOD)
    prompter, output = prompted(run, "wait began 0 1\npause\n")
    to_the_end(run, prompter)
    assert len(output) == len(run.outcome.failed) == 1
    assert runtime.of(request.Abort) == []


def test_lines_left_after_an_abort_are_left_alone(running):  # R-E07
    run, _ = running(event.Result(False, "stopped", 0, 4, 1.0, 0.1, {}, (), ""))
    prompter, output = prompted(run, "wait began 0 1\npause\n")
    to_the_end(run, prompter)
    assert (output, run.outcome.failed, prompter.is_over) == ([], (), True)
