"""Virtual time: the whole box assembly against real time and against its own physics, and its hash.

The commands of one run are recorded and replayed through `mj_step` alone: that is what the physics costs. Runs and
replays alternate, so that the ratio holds when the machine's speed drifts. Three runs under different hash seeds must
give one hash.
"""

import argparse
import copy
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path
from time import process_time

import mujoco
import numpy as np

from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import Preparation, prepare
from onika.host.processes.realtime_scheduling import still_garbage
from onika.host.program import RuntimeProgram
from onika.host.units.virtual import VirtualDriver
from onika.store.site import open_site
from onika.wire import event, request
from onika.workcell.cell import file_world


class Silent:
    """A gate that only keeps the result."""

    def __init__(self) -> None:
        self.result: event.Result | None = None

    def tell(self, one: event.Event, subsystem: str = "", session: str = "") -> None:
        """Keep it if it is the result."""
        if isinstance(one, event.Result):
            self.result = one

    def requests(self) -> list[tuple[int, request.Request]]:
        """Nobody asks."""
        return []

    def hearing(self, session: str) -> None:
        """Nobody is there who could be silent."""

    def deaf_ns(self) -> int:
        """It hears everything."""
        return 0

    def overhear(self, listener: object) -> None:
        """Nothing is recorded."""


class Recorder:
    """Stands in for `mj_step` during one run and keeps every command."""

    def __init__(self) -> None:
        self.parts: list[tuple[mujoco.MjModel, mujoco.MjData, list[np.ndarray]]] = []

    def __call__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        """Record the command, then step."""
        if not self.parts or self.parts[-1][0] is not model:
            self.parts.append((model, copy.copy(data), []))
        self.parts[-1][2].append(data.ctrl.copy())
        mujoco.mj_step(model, data)

    def replay(self) -> float:
        """CPU seconds of the recorded steps, physics alone."""
        took = 0.0
        for model, start, commands in self.parts:
            data = copy.copy(start)
            control, step = data.ctrl, mujoco.mj_step
            began = process_time()
            for command in commands:
                control[:] = command
                step(model, data)
            took += process_time() - began
        return took


def whole_run(prepared: Preparation) -> tuple[float, event.Result]:
    """CPU seconds of one run, and its result."""
    server = Silent()
    driver = VirtualDriver(("rt0",), server.tell)
    driver.offer(prepared.plan.worlds)
    program = RuntimeProgram(server, driver, ModuleFacts(), ("rt0",))
    program.applications.take("", prepared)
    began = process_time()
    program.applications.begin("", request.Begin(watch=("LAMP",)))
    while server.result is None:
        program.advance(1_000_000_000)
    return process_time() - began, server.result


def hashes(application: str) -> list[str]:
    """The hash of three runs of the program itself, each with another order of sets."""
    command = [str(Path(sys.executable).with_name("onika")), "run", application, "--virtual", "--json"]
    found = []
    for seed in ("0", "1", "4711"):
        ran = subprocess.run(
            command, env=os.environ | {"PYTHONHASHSEED": seed}, capture_output=True, text=True, check=True
        )
        found.append(json.loads(ran.stdout.splitlines()[-1])["hash"])
    return found


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--application", default="assemble")
    parser.add_argument("--rounds", type=int, default=5)
    given = parser.parse_args()
    planned = prepare_run(given.application, open_site([], {}, None))
    assert planned.plan is not None, planned.faults
    prepared = prepare(planned.plan, planned.targets, ModuleFacts())
    recorder = Recorder()
    real_step, file_world.mj_step = file_world.mj_step, recorder
    whole_run(prepared)
    file_world.mj_step = real_step
    still_garbage()  # as in the runtime itself
    totals, physics, result = [], [], None
    for _ in range(given.rounds):
        took, result = whole_run(prepared)
        totals.append(took)
        physics.append(recorder.replay())
    assert result is not None and result.completed, result
    ratio = statistics.median(total / alone for total, alone in zip(totals, physics, strict=True))
    steps = sum(len(commands) for _, _, commands in recorder.parts)
    print(f"{given.application}: {result.runtime_s:.2f} s simulated, {steps} steps, values {result.values}")
    for what, seconds in (("whole run", totals), ("physics alone", physics)):
        middle = statistics.median(seconds)
        print(f"{what:<14} {middle:.3f} s CPU, {result.runtime_s / middle:.1f}x real time")
    print(f"ratio          {ratio:.2f}  (median of {given.rounds} rounds)")
    found = sorted(set(hashes(given.application)))
    print(f"hash           {'the same in three runs' if len(found) == 1 else 'DIFFERENT'}: {', '.join(found)}")


if __name__ == "__main__":
    main()
