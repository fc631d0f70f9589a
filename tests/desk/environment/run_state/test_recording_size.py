from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.recording_size import with_recording_size
from onika.desk.environment.run_state.run import begun
from onika.model.application import Application
from onika.model.syntax import Syntax
from onika.wire.plan import Plan


def run_recorded_in(path):
    membership = StepMembership.of(Application("empty", False, ()), Syntax((), ()))
    return begun("a1", Plan("empty", (), ()), 1, 0.0, membership).shown(recording=str(path))


def test_the_size_of_a_recording_is_that_of_its_file(tmp_path):  # R-X05
    (tmp_path / "run.mcap").write_bytes(b"x" * 321)
    assert with_recording_size(run_recorded_in(tmp_path / "run.mcap")).view.recorded_bytes == 321


def test_a_recording_that_was_moved_away_has_no_size(tmp_path):  # R-X05
    assert with_recording_size(run_recorded_in(tmp_path / "gone.mcap")).view.recorded_bytes == 0
