"""How a run ended that failed: its result, the tasks that failed, and whether every drive held in time."""

from pathlib import Path
from typing import Any

from kit.process.cli_process import CliProcess

SILENCE_NS = 50_000_000


def aborted(console: CliProcess) -> dict[str, Any]:
    """The result of an aborted run, its cause in English, of which nothing is left behind."""
    result = console.result()
    if isinstance(result["cause"], dict):
        result["cause"] = result["cause"]["text"]
    assert (result["state"], result["exit"], console.code()) == ("aborted", 1, 1), result
    assert console.left_over() == []
    assert not [path for path in Path("/dev/shm").iterdir() if "onika" in path.name]
    return result


def assert_held_in_time(console: CliProcess) -> None:
    """The first step of the world more than 50 ms after the last command no longer follows it."""
    moves = [event for event in console.events if event["event"] == "drive"]
    assert moves[0]["state"] == "DRIVEN"
    held = moves[1]
    assert held["state"] != "DRIVEN"
    assert held["previous_step_ns"] - held["last_command_ns"] <= SILENCE_NS
    assert "DRIVEN" not in [event["state"] for event in moves[1:]]


def failures(console: CliProcess) -> dict[str, dict[str, Any]]:
    """The event of each task that failed, by the task's name."""
    return {event["task"]: event for event in console.events if event["event"] == "failed"}
