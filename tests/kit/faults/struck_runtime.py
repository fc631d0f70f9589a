"""A real runtime in wall time that is asked what would follow from a fault, and then struck by that very fault (X24).

In subsystem flow0 an application runs, begun by the session `beginner`: `arm` commands a device from unit rt0, `push`
turns its first joint from rt1, `lamp` is passive on rt2. In subsystem hand the session `holder` has the other arm:
`arm2` on rt0, `push2` on rt1. `watcher` is told everything.
"""

import os
import re
import select
import signal
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import monotonic

from kit.faults.foreseen_changes import Change, Changes, changes_of, gathered
from kit.faults.struck_tasks import SICK, struck_tasks
from kit.plans.plan_builder import action
from kit.process.traces import Traces
from onika.desk.run.remote_runtime import RemoteRuntime, connect
from onika.desk.run.runtime_conversation import NumberedResponse
from onika.wire import event, holding, live, request, steer
from onika.wire.foresight import Foreseen, Foresight, WhatIf
from onika.words.reason import Reason

LEASE_S = 1.0
"""How long a session may be silent here: longer than a busy machine keeps this program waiting."""
UNITS = ("rt0", "rt1", "rt2")
_PATIENCE_S = 15.0
_SETTLED_S = 0.4
"""When nothing was told for so long, everything has followed."""
_STEADY_S = 0.2
_LATE = ("runtime.device_silent", "runtime.device_silent_late", "runtime.drive_tripped")
"""What a task fails with where the machine was late: its device, or it itself to its drive, was silent for too long."""
_GOES_ON_S = 3.0
"""How long a drive may hold for no other reason than that the machine is busy."""
_AT_WORK = {"arm_left_kin": ("flow0/arm", "flow0/push"), "arm_right_kin": ("hand/arm2", "hand/push2")}
"""By device: the tasks that drive it."""


class MachineWasLateError(Exception):
    """The machine itself has kept a device silent for a task: what came is not what the fault has done."""


class StruckRuntime:
    """The runtime, its sessions, and what was told since the fault came."""

    def __init__(self, folder: Path) -> None:
        self._folder, self.traces = folder, Traces(folder)
        self._shop = struck_tasks(folder)
        words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--no-fifo", "--no-black-box"]
        words += ["--lease", str(LEASE_S), *(word for unit in UNITS for word in ("--rtpu", unit))]
        environment = os.environ | self.traces.environment
        self._process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment)
        self._there = _address(self._process)
        self._sessions: dict[str, RemoteRuntime] = {}
        self._names: dict[str, str] = {}
        self._now: dict[tuple[str, str], str] = {}
        self._told: list[Change] = []
        self._pressed, self._is_stopped = "", False
        self._silent: RemoteRuntime | None = None
        self._began_at = self._told_at = monotonic()
        self.failures: list[event.Failed] = []
        self._was_late = False
        self.is_spent = False
        self._join("watcher")
        self.ask(live.Attend(("*",)))

    def close(self) -> None:
        """End it, and everybody."""
        for name in tuple(self._sessions):
            self._part(name)
        self._process.terminate()
        self._process.wait(_PATIENCE_S)
        if self._process.stdout is not None:
            self._process.stdout.close()
        self.traces.end()

    # What it does

    def begin(self, **begin: object) -> None:
        """Have the application begun, and let it work."""
        self._join("beginner")
        plan = self._shop.plan([action("arm", "push", "lamp")])
        prepared = self.ask(request.Prepare(plan, ()), "beginner")
        if not isinstance(prepared, request.Prepared) or prepared.faults:
            raise ValueError(str(prepared))
        self._do(request.Begin(**begin), "beginner")  # type: ignore[arg-type]
        self._move("arm_left_kin", "flow0/lamp")

    def hold(self) -> None:
        """Have the other arm turned on by hand, and let it work."""
        self._join("holder")
        names = ("arm2", "push2")
        tasks = tuple(self._shop.planned(name) for name in names)
        code = tuple(self._shop.code(name) for name in names)
        change = live.Change("hand", spawn=tasks, code=code, on=tuple(live.Turn(name) for name in names))
        accepted = self.ask(change, "holder")
        if not isinstance(accepted, live.Accepted):
            raise ValueError(str(accepted))
        self._move("arm_right_kin")

    def settle(self) -> None:
        """End everything that this fault has left, so that the next one finds nothing of it."""
        for path in self._folder.glob(f"*{SICK}"):
            path.unlink()
        if self._pressed:
            self._do(live.Touch("boxes", self._pressed, 0.0))
        if self._silent is not None:
            self._silent.__exit__(None, None, None)
        self._pressed, self._silent = "", None
        for name in ("beginner", "holder"):
            if name in self._sessions:
                self._part(name)
        self._fall_quiet()
        for subsystem in self._living():
            self.until(partial(self._takes, subsystem))
            is_run = subsystem == "flow0"
            self.ask(request.Abort(Reason.plain("enough"), subsystem) if is_run else live.Close(subsystem))
        self.until(lambda: not self._living())
        if self._is_stopped:  # only a holder leaves a stop, while there is one
            self._do(live.Reset())
        self._is_stopped = self._was_late = False
        self.failures.clear()

    # What is asked, and what is told

    def foresee(self, fault: str, subject: str = "") -> Foresight:
        """What follows from a fault now; `beginner` and `holder` stand for the sessions themselves."""
        self._judge_machine()
        answer = self.ask(WhatIf(fault, self._names.get(subject, subject)))
        if not isinstance(answer, Foreseen):
            self._fall_quiet()
            self._judge_machine()
            raise TypeError(str(answer))
        return answer.foresights[0]

    def is_pausing(self) -> bool:
        """Whether the application's flow pauses after its current action."""
        positions = self.ask(steer.Who())
        if not isinstance(positions, steer.Positions):
            raise TypeError(str(positions))
        return any(flow.is_pausing for flow in positions.flows)

    def strike(self, fault: str, subject: str = "") -> Changes:
        """Let the fault come, and tell what has changed when everything has followed."""
        self._told.clear()
        self._began_at = self._told_at = monotonic()
        getattr(self, "_" + fault.replace("-", "_"))(subject)
        self._fall_quiet()
        end = monotonic() + _GOES_ON_S
        self.until(lambda: monotonic() > end or not any(map(self._holds_at_work, _AT_WORK)))
        if not fault.startswith(("devices", "unit")):
            self._judge_machine()
        return gathered(self._told)

    def _judge_machine(self) -> None:
        if self._was_late:
            raise MachineWasLateError(str(self.failures[-1].text))

    def ask(self, message: request.Request, who: str = "watcher") -> request.Response:
        """Ask in a session; the others go on beating meanwhile."""
        number = self._sessions[who].send(message)
        answers: list[request.Response] = []
        end = monotonic() + _PATIENCE_S
        while not answers:
            if monotonic() > end:
                raise TimeoutError(f"no answer to {message}")
            answers += [reply.response for name, reply in self._listen() if (name, reply.number) == (who, number)]
        return answers[0]

    def until(self, holds: Callable[[], bool]) -> None:
        """Beat and listen until this holds."""
        end = monotonic() + _PATIENCE_S
        while not holds():
            if monotonic() > end:
                self._judge_machine()
                raise TimeoutError(f"it did not come: {self._now}, {self.failures}")
            self._listen()

    def _do(self, message: request.Request, who: str = "watcher") -> None:
        response = self.ask(message, who)
        if response != request.Done():
            raise ValueError(str(response))

    def _fall_quiet(self) -> None:
        self._told_at = monotonic()
        self.until(lambda: monotonic() > self._told_at + _SETTLED_S)

    def _listen(self) -> list[tuple[str, NumberedResponse]]:
        """Take in what has come for every session; the replies among it."""
        readers = [fd for runtime in self._sessions.values() for fd in runtime.readers()]
        select.select(readers, [], [], 0.02)
        replies = []
        for name, runtime in self._sessions.items():
            for message in runtime.messages():
                if isinstance(message, NumberedResponse):
                    replies.append((name, message))
                elif name == "watcher":
                    self._hear(message)
        return replies

    def _hear(self, message: event.Event) -> None:
        now = monotonic()
        if isinstance(message, event.Failed):
            self.failures.append(message)
            self._was_late |= any(key in repr(message.text) for key in _LATE)
        for change in changes_of(message, 1000.0 * (now - self._began_at)):
            self._told.append(change)
            self._now[change.kind, change.subject] = change.after
            if change.kind != "drive":  # a busy machine lets drives hold and go on at any time
                self._told_at = now

    def _move(self, device: str, *besides: str) -> None:
        """Wait until it is driven and these are at work too, and the world has taken in its new arm."""
        tasks = (*_AT_WORK[device], *besides)
        self.until(lambda: self._has(device, "DRIVEN", tasks))
        steady_at = monotonic() + _STEADY_S
        self.until(lambda: monotonic() > steady_at and self._has(device, "DRIVEN", tasks))

    def _takes(self, subsystem: str) -> bool:
        """Take it, which may be refused as long as it is not noticed that its holder is gone."""
        return self.ask(live.Take(subsystem)) == request.Done()

    def _holds_at_work(self, device: str) -> bool:
        return self._has(device, "HELD", _AT_WORK[device])

    def _has(self, device: str, drive: str, tasks: tuple[str, ...]) -> bool:
        """Whether a drive is in this state, and these tasks are ON."""
        is_so = self._now.get(("drive", f"boxes:{device}")) == drive
        return is_so and all(self._now.get(("task", task)) == "ON" for task in tasks)

    def _living(self) -> set[str]:
        tasks = {subject: state for (kind, subject), state in self._now.items() if kind == "task"}
        return {task.partition("/")[0] for task, state in tasks.items() if state != "KILLED"}

    # Sessions

    def _join(self, name: str) -> None:
        runtime = connect(*self._there)
        runtime.__enter__()
        self._sessions[name] = runtime
        answer = self.ask(holding.Sessions(), name)
        if not isinstance(answer, holding.Company):
            raise TypeError(str(answer))
        self._names[name] = answer.you

    def _part(self, name: str) -> None:
        self._sessions.pop(name).__exit__(None, None, None)

    # Faults

    def _pid(self, *words: str) -> int:
        """The process of the runtime whose command line has all of these words."""
        processes = self.traces.processes().items()
        return next(pid for pid, command in processes if all(word in command for word in words))

    def _task(self, task: str) -> None:
        self._folder.joinpath(task.partition("/")[2] + SICK).touch()
        self.until(lambda: bool(self._told))

    def _button(self, device: str) -> None:
        self._pressed = f"panic_{device.split('_')[1]}"
        self._do(live.Touch("boxes", self._pressed, 1.0))

    def _holder(self, session: str) -> None:
        """Nobody serves its connection any more, which is open still."""
        self._silent = self._sessions.pop(session)
        end = monotonic() + LEASE_S + 1.0
        self.until(lambda: self._told_at > self._began_at or monotonic() > end)

    def _stop(self, _subject: str) -> None:
        self._is_stopped = True
        self._do(request.Stop(Reason.plain("enough")))

    def _unit_killed(self, unit: str) -> None:
        self._send(signal.SIGKILL, "onika.host.units.rtpu", f"--name {unit}")

    def _unit_frozen(self, unit: str) -> None:
        self._send(signal.SIGSTOP, "onika.host.units.rtpu", f"--name {unit}")
        self.until(lambda: ("unit", unit) in self._now)

    def _devices_killed(self, _subject: str) -> None:
        self._send(signal.SIGKILL, "onika.host.units.device_server")

    def _devices_frozen(self, _subject: str) -> None:
        self._send(signal.SIGSTOP, "onika.host.units.device_server")
        self.until(lambda: ("unit", "device server") in self._now)

    def _send(self, signum: signal.Signals, *words: str) -> None:
        """This runtime is not whole any more."""
        self.is_spent = True
        os.kill(self._pid(*words), signum)

    def _runtime_killed(self, _subject: str) -> None:
        self.is_spent = True
        self._process.kill()


def _address(process: "subprocess.Popen[str]") -> tuple[str, str]:
    """Where it listens, and its token."""
    if process.stdout is None:
        raise TypeError("expected a pipe")
    line = process.stdout.readline()
    match = re.search(r"listening on (\S+), token in (.*)$", line)
    if match is None:
        raise ValueError(line)
    return match[1], Path(match[2]).read_text(encoding="utf-8").strip()
