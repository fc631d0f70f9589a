"""Asks the program that knows physics for a first draft of a robot's description."""

import subprocess
import sys

from msgspec import MsgspecError, msgpack

from onika.wire.robot_draft import RobotDraft
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason

DRAFTER = (sys.executable, "-m", "onika.workcell.drafting.draft")
_PATIENCE_S = 300


def drafted(source: WorldSource, name: str, file: str) -> RobotDraft:
    """The draft of the robot `name` with the model `file`; with a refusal where there is none."""
    try:
        done = subprocess.run(  # noqa: S603 - our own program
            [*DRAFTER, name, file],
            input=msgpack.encode(source),
            capture_output=True,
            timeout=_PATIENCE_S,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return RobotDraft(refusal=Reason.of("desk.robot_late", seconds=_PATIENCE_S))
    try:
        return msgpack.decode(done.stdout, type=RobotDraft)
    except MsgspecError:
        lines = done.stderr.decode("utf-8", "replace").strip().splitlines() or [str(done.returncode)]
        return RobotDraft(refusal=Reason.of("desk.robot_program", why=lines[-1]))
