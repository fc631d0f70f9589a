"""Blows: a process of a running program is killed or frozen at a moment, and what came of it is measured.

    blow = Blow(Kind.UNIT, signal.SIGSTOP, after_s=0.3)
    aftermath = strike(Stage.RUN, blow, tmp_path)
    assert aftermath.faults() == []

A moment counts from when the process appears, so that it may fall into its start. A program that goes on, or stands
frozen, gets one Ctrl-C a moment later, as a terminal gives it: to everyone in the foreground.

`tools/strike.py` deals out many at random."""

import os
import random
import select
import signal
import subprocess
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import pairwise
from pathlib import Path
from time import monotonic

from kit.labs.laboratory import Laboratory, job, joints
from kit.process.cli_process import ONIKA, Event, in_english
from kit.process.traces import Traces
from onika.record.reader import UNREADABLE, Reader

STOPPED_NS = 100_000_000
"""After so long without a command a drive has to hold."""
ENDED_S, LEFT_S, TOLD_S = 3.0, 2.0, 1.0
_LIVES_ON_S = 1.5
"""A program that has not ended after so long gets a Ctrl-C."""
_PATIENCE_S = 15.0
_APPEARS_S = 20.0
FREEZES = (signal.SIGSTOP,)
_ARM = ("puma 500", "diff 500", "gravcomp 250", "pd 500", "torque_sum 500", "led_monitor 50", "jtraj 250")


class Kind(StrEnum):
    """The kinds of processes, each by words of its command line; the command is the program that was started."""

    COMMAND = ""
    GUARD = "guard.py runtime"
    RUNTIME = "onika.host --link-fd"
    UNIT = "onika.host.units.rtpu"
    DEVICES = "onika.host.units.device_server"
    LOADER = "onika.host.loading.loader"
    RECORDING = "onika.host.recording.recording_process"
    LISTENER = "onika.host.sessions.listener_main"


class Stage(StrEnum):
    """What is hit: a run of the command line, with a recording or in virtual time; a page; a runtime that listens."""

    RUN = "run"
    RECORDED = "recorded"
    VIRTUAL = "virtual"
    PAGE = "page"
    LISTENING = "listening"


_WALL = (Kind.COMMAND, Kind.GUARD, Kind.RUNTIME, Kind.UNIT, Kind.DEVICES, Kind.LOADER)
KINDS = {
    Stage.RUN: _WALL,
    Stage.RECORDED: (*_WALL, Kind.RECORDING),
    Stage.VIRTUAL: (Kind.COMMAND, Kind.GUARD, Kind.RUNTIME, Kind.LOADER),
    Stage.PAGE: _WALL,
    Stage.LISTENING: (*_WALL, Kind.LISTENER),
}
"""Which processes there are."""


@dataclass(frozen=True, slots=True)
class Blow:
    """A signal to the process of a kind, so long after it has appeared."""

    kind: Kind
    signum: signal.Signals
    after_s: float

    @property
    def is_freeze(self) -> bool:
        """Whether the process lives on."""
        return self.signum in FREEZES

    def __str__(self) -> str:
        return f"{self.kind.name} {self.signum.name} after {self.after_s:.2f} s"


@dataclass(slots=True)
class Aftermath:
    """What came of a blow; times in s, None where there was nothing to measure."""

    stage: Stage
    blow: Blow
    has_hit: bool
    code: int | None
    ended_s: float | None
    """From the blow, or from the Ctrl-C where one was needed, to the end of the command."""
    had_interrupt: bool
    told_s: float | None
    """From the blow to the first line about it; where a Ctrl-C was needed, from that."""
    silence_ns: int | None
    """How long a drive that was driven heard nothing before it held."""
    left: list[str]
    unreadable: str
    """Why a recording does not read."""
    output: list[str] = field(default_factory=list)

    def faults(self, patience: float = 1.0) -> list[str]:
        """Everything that is not as it has to be; empty: all is well. `patience` stretches times of the wall."""
        faults = [f"left behind: {trace}" for trace in self.left]
        if any("Traceback" in line for line in self.output):
            faults.append("a traceback")
        if self.code is None or self.ended_s is None or self.ended_s > patience * ENDED_S:
            faults.append(f"ended after {self.ended_s} s")
        if self.told_s is not None and self.told_s > patience * (ENDED_S if self.had_interrupt else TOLD_S):
            faults.append(f"told after {self.told_s:.2f} s")
        if self.silence_ns is not None and self.silence_ns > STOPPED_NS:
            faults.append(f"a drive went on for {self.silence_ns / 1e6:.0f} ms")
        if self.unreadable:
            faults.append(f"unreadable recording: {self.unreadable}")
        return faults


def blows(stage: Stage, kind: Kind, count: int, signals: Sequence[signal.Signals], seed: int) -> Iterator[Blow]:
    """So many random blows at a kind of process: half of them while it starts, the others while it works."""
    chance = random.Random(f"{stage} {kind} {seed}")
    for number in range(count):
        longest_s = 0.7 if number % 2 else 4.0
        yield Blow(kind, chance.choice(signals), chance.uniform(0.0, longest_s))


def strike(stage: Stage, blow: Blow, folder: Path) -> Aftermath:
    """Start the program, deal the blow, and see it to its end."""
    traces, recording = Traces(folder), folder / "run.mcap"
    program = _Program(_words(stage, folder, recording), traces)
    try:
        hit_at = program.deal(blow)
        began_at = program.until_end(hit_at + _LIVES_ON_S) if hit_at is not None else monotonic()
        had_interrupt = program.code() is None
        if had_interrupt:
            began_at = program.interrupt()
            program.until_end(began_at + _PATIENCE_S)
        else:
            began_at = hit_at or began_at
        code, ended_at = program.code(), program.ended_at
        left = traces.left_over(LEFT_S)
    finally:
        traces.end()
        program.close()
    return Aftermath(
        stage,
        blow,
        hit_at is not None,
        code,
        None if ended_at is None else ended_at - began_at,
        had_interrupt,
        None if blow.kind is Kind.COMMAND else program.told_s(began_at),
        _silence_ns(program.events()),
        left,
        _complaint(recording),
        program.output(),
    )


class _Program:
    """The command as a process group of its own; its lines with the moments at which they came."""

    def __init__(self, words: Sequence[str], traces: Traces) -> None:
        self._traces = traces
        self._process = subprocess.Popen(
            [*ONIKA, *words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env=os.environ | traces.environment,
            start_new_session=True,
        )
        self._began_at = monotonic()
        self._lines: list[tuple[float, str]] = []
        self._rest = b""
        self._is_open = True
        self.ended_at: float | None = None

    def deal(self, blow: Blow) -> float | None:
        """Wait for the process, and for the moment; when it was hit, None where it never was there or is gone."""
        pid = self._victim(blow)
        if pid is None:
            return None
        self.until_end(monotonic() + blow.after_s)
        if self.code() is not None:
            return None
        try:
            os.kill(pid, blow.signum)
        except ProcessLookupError:
            return None
        return monotonic()

    def _victim(self, blow: Blow) -> int | None:
        """A command is frozen only when there is a runtime: before, nobody is there to wake it."""
        if blow.kind is not Kind.COMMAND:
            return self._appears(blow.kind)
        if blow.is_freeze and self._appears(Kind.RUNTIME) is None:
            return None
        return self._process.pid

    def _appears(self, kind: Kind) -> int | None:
        until = self._began_at + _APPEARS_S
        while monotonic() < until and self.code() is None:
            self._read(0.005)
            for pid, words in self._traces.processes().items():
                if kind in words:
                    return pid
        return None

    def until_end(self, until: float) -> float:
        """Read on until the program has ended, or until then; the time."""
        while self.code() is None and monotonic() < until:
            self._read(min(0.01, max(until - monotonic(), 0.0)))
        if self.code() is not None:
            self.ended_at = self.ended_at or monotonic()
            while self._is_open and self._read(0.0):
                pass
        return monotonic()

    def code(self) -> int | None:
        """The exit code, None while it lives."""
        return self._process.poll()

    def interrupt(self) -> float:
        """Ctrl-C to everyone in the foreground; when."""
        os.killpg(self._process.pid, signal.SIGINT)
        return monotonic()

    def close(self) -> None:
        """End it."""
        self._process.kill()
        self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()

    def output(self) -> list[str]:
        """Everything that was printed."""
        return [line for _, line in self._lines]

    def events(self) -> list[Event]:
        """What was said as events."""
        return [in_english(line) for line in self.output() if line.startswith("{")]

    def told_s(self, since: float) -> float | None:
        """How long it took until something was said."""
        return next((at - since for at, line in self._lines if at >= since and _is_news(line)), None)

    def _read(self, wait_s: float) -> bool:
        stream = self._process.stdout
        assert stream is not None
        if not self._is_open:
            select.select([], [], [], wait_s)
            return False
        if not select.select([stream], [], [], wait_s)[0]:
            return False
        data = os.read(stream.fileno(), 1 << 16)
        *whole, self._rest = (self._rest + data).split(b"\n")
        now = monotonic()
        self._lines += [(now, line.decode("utf-8", "replace")) for line in whole]
        self._is_open = bool(data)
        return bool(data)


def _is_news(line: str) -> bool:
    """Whether a line tells that something is not as it was."""
    if not line.startswith("{"):
        return bool(line.strip())
    event = in_english(line)
    return bool(event["event"] != "drive" or event["state"] != "DRIVEN")


def _words(stage: Stage, folder: Path, recording: Path) -> list[str]:
    base = folder / "base"
    match stage:
        case Stage.PAGE:
            base.mkdir(parents=True, exist_ok=True)
            return ["page", "--no-browser", "--port", "0", "--no-forecast", "--base", str(base)]
        case Stage.LISTENING:
            return ["runtime", "--listen", "127.0.0.1:0", "--no-console"]
    words = ["run", _application(base), "--json"]
    if stage is not Stage.RUN:
        words += ["--record", str(recording)]
    if stage is Stage.VIRTUAL:
        words += ["--virtual", "--scale", "1"]
    return words


def _application(base: Path) -> str:
    """One motion of the arm that lasts longer than any blow waits."""
    laboratory = Laboratory(base)
    laboratory.configuration("blowC", *_ARM)
    there = joints("there", 0.5, -1.57, 1.57, 0.0, 0.0, 0.0, duration=10.0)
    return str(laboratory.application("blow", [job("blowC", "Joint job"), there]))


def _silence_ns(events: Sequence[Event]) -> int | None:
    """The longest time for which a drive that was driven had heard nothing at the step before it held."""
    changes = [event for event in events if event["event"] == "drive"]
    held = [after for before, after in pairwise(changes) if before["state"] == "DRIVEN" != after["state"]]
    return max((event["previous_step_ns"] - event["last_command_ns"] for event in held), default=None)


def _complaint(recording: Path) -> str:
    """Why a recording does not read; one that was never begun is none."""
    if not recording.exists() or not recording.stat().st_size:
        return ""
    try:
        Reader(recording).close()
    except UNREADABLE as wrong:
        return repr(wrong)
    return ""
