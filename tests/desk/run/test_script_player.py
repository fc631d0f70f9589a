from onika.desk.run.script_player import Prompter
from onika.desk.run.steering_script import read
from onika.wire import event, request, steer

BEGAN = event.Began(0, 0, 2, "jmoveC aside", 1.0)
GOOD = event.Result(True, "", 4, 4, 9.0, 0.1, {}, (), "abc")


def prompted(one, text):
    """A prompter of this script, and what it tells."""
    told = []
    cues, faults = read(text, "s", one.cast)
    assert faults == []
    return Prompter(one, cues, lambda line, faults, where: told.append((line, [str(f) for f in faults], where))), told


def to_the_end(one, prompter):
    while not one.is_over:
        list(one.hear())
        while prompter.go_on():
            pass
        one.go_on(prompter.until_s)
    while prompter.go_on():
        pass


def test_lines_are_carried_out_one_after_another_at_their_moments(running):  # R-E07
    one, runtime = running(BEGAN, GOOD)
    prompter, told = prompted(one, "pause\nwait began 0 1\nwait 0.5\ncontinue\n")
    to_the_end(one, prompter)
    assert [line for line, _, _ in told] == ["pause", "wait began 0 1", "wait 0.5", "continue"]
    assert prompter.is_over
    assert runtime.of(steer.Pause, steer.Resume) == [steer.Pause(""), steer.Resume("")]
    assert steer.Onward(1.5) in runtime.asked


def test_nothing_is_done_while_the_clock_of_a_held_run_goes_on(running):  # R-E07
    one, runtime = running(BEGAN)
    prompter, told = prompted(one, "pause\n")
    assert not prompter.go_on()
    assert runtime.of(steer.Pause) == told == []
    list(one.hear())
    assert prompter.go_on()


def test_nothing_is_done_while_a_task_asks(running):  # law 25
    one, runtime = running(is_held=False)
    one.whereabouts.hear(event.Asked("flow0", "gauge", "", (), 0.5))
    prompter, _ = prompted(one, "pause\n")
    assert not prompter.go_on()
    assert runtime.of(steer.Pause) == []


def test_who_is_told_with_the_positions(running):  # R-X03
    one, runtime = running(GOOD)
    runtime.positions = (steer.Position("flow0", "running", 0),)
    prompter, told = prompted(one, "who\n")
    to_the_end(one, prompter)
    assert told == [("who", [], runtime.positions)]


def test_the_first_line_that_fails_ends_the_script_and_the_run(running):  # R-E07
    one, runtime = running(BEGAN, GOOD)
    prompter, told = prompted(one, "# a comment\nexpect LAMP == 0\npause\n")
    to_the_end(one, prompter)
    assert [line for line, _, _ in told] == ["expect LAMP == 0"]
    assert runtime.of(request.Abort) == [request.Abort("the script fails at s:2")]
    assert [str(one.place) for one in one.outcome.failed] == ["s:2"]
    assert runtime.of(steer.Pause) == []


def test_lines_left_after_a_good_end_fail_without_an_abort(running):  # R-E07
    one, runtime = running(GOOD)
    prompter, told = prompted(one, "wait began 0 1\npause\n")
    to_the_end(one, prompter)
    assert len(told) == len(one.outcome.failed) == 1
    assert runtime.of(request.Abort) == []


def test_lines_left_after_an_abort_are_left_alone(running):  # R-E07
    one, _ = running(event.Result(False, "stopped", 0, 4, 1.0, 0.1, {}, (), ""))
    prompter, told = prompted(one, "wait began 0 1\npause\n")
    to_the_end(one, prompter)
    assert (told, one.outcome.failed, prompter.is_over) == ([], (), True)
