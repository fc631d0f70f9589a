"""The size of a run's recording, once the run is over (requirement X05)."""

from pathlib import Path

from onika.desk.environment.run_state.run import Run


def with_recording_size(run: Run) -> Run:
    """A run that is over, with the size of its recording."""
    if not run.view.recording:
        return run
    try:
        size = Path(run.view.recording).stat().st_size
    except OSError:
        size = 0  # somebody has moved it away already
    return run.shown(recorded_bytes=size)
