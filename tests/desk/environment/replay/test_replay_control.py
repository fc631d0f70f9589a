import pytest

from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.replay import replay_place
from onika.desk.environment.replay.replay_control import ReplayControl, refusal
from onika.desk.environment.replay.session_player import SessionPlayer
from onika.files.state import session_log
from onika.wire import act


class Time:
    """Seconds that pass when a test says so."""

    now_s = 0.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def replay(session):
    """A replay of a session whose lines are half a second apart, that pauses."""
    session.new("sine", "servo")
    lines, _ = session_log.read(session.log, "s.log")
    time = Time()
    control = ReplayControl(time, "s.log", is_playing=False)
    place = replay_place.made(lines, [session.before], session.folder / "replay", "s.log")
    player = SessionPlayer(lines, place, {**HANDLERS, act.SteerReplay: control.steer}, "s.log")
    control.begin(player)
    return control, player, time


def steer(player, wish, speed=0.0):
    answers = []
    player.environment.do(act.SteerReplay(wish, speed), "me", answers.append)
    return answers[0].no


def test_nothing_happens_while_it_pauses_and_a_step_is_one_line(replay):  # R-H08
    control, player, time = replay
    time.now_s = 100.0
    assert not control.advance() and player.position == 0
    assert steer(player, "step") is None
    assert control.advance() and not control.advance()
    assert player.position == 1 and player.environment.tree.replay.event == "Start_Onika"


@pytest.mark.parametrize("speed", [0.5, 1.0, 10.0])
def test_it_takes_the_time_of_the_session_by_its_speed(replay, speed):  # R-H08
    control, player, time = replay
    steer(player, "play", speed)
    waits = 0
    while not player.is_over:
        if not control.advance():
            time.now_s += 0.01
            waits += 1
    took_s = player.lines[-1].at_s - player.lines[0].at_s
    assert waits * 0.01 == pytest.approx(took_s / speed, rel=0.05, abs=0.05)
    shown = player.environment.tree.replay
    assert (shown.position, shown.is_playing, shown.at_s) == (len(player.lines), False, pytest.approx(took_s))


def test_it_goes_to_its_end_at_once(replay):  # R-H08
    control, player, _ = replay
    steer(player, "end")
    while control.advance():
        pass
    assert player.is_over and player.environment.tree.replay.faults_in_all == 0


def test_a_speed_out_of_range_is_refused(replay):  # R-H08
    _, player, _ = replay
    for speed in (0.01, 1e4, -1.0):
        assert steer(player, "play", speed).reason.key == "replay.speed_range"


def test_whoever_looks_may_steer_and_look_and_nothing_else():  # R-H08
    assert not refusal(act.SteerReplay("play")) and not refusal(act.Peek("x"))
    assert refusal(act.New()) and refusal(act.Prefer({})) and refusal(act.Run("a1"))


def test_without_a_replay_there_is_nothing_to_steer(session):  # R-H08
    assert session.no(act.SteerReplay("play")).reason.key == "replay.none_here"
