"""Two arms in virtual time: `assemble_together` against real time and against the physics of both arms.

Whole runs and replays of their commands through `mj_step` alone alternate, as in `virtual.py`. Beside that: whether the
lamp lights when every box stands up to 1 mm elsewhere, and how near the arms come to each other on the way.

Asked for are 10 times real time at least, 3.5 times the physics at most, and all lamps lit.
"""

import argparse
import statistics

import mujoco
from virtual import Recorder, Silent, whole_run

from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import Preparation, prepare
from onika.host.processes.realtime_scheduling import still_garbage
from onika.host.program import RuntimeProgram
from onika.host.units.virtual import VirtualDriver
from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.wire import request
from onika.workcell.cell import file_world
from onika.workcell.cell.file_world import FileWorld

APPLICATION = "assemble_together"
LEAST_SPEED, MOST_PHYSICS = 10.0, 3.5
_LOOK_NS = 20_000_000
_FAR_M = 1.0


class Clearance:
    """The least distance between the two arms, looked at every 20 ms."""

    def __init__(self, world: FileWorld) -> None:
        self.least_m, self.at_s = _FAR_M, 0.0
        self._world = world
        self._next_ns = 0

    def look(self) -> None:
        """Look at it, if it is time."""
        if self._world.now_ns >= self._next_ns:
            self._next_ns = self._world.now_ns + _LOOK_NS
            model, data = self._world._plant.model, self._world._plant.data
            left, right = (self._shapes(side) for side in ("left", "right"))
            pairs = ((one, other) for one in left for other in right)
            nearest = min((mujoco.mj_geomDistance(model, data, *pair, _FAR_M, None) for pair in pairs), default=_FAR_M)
            if nearest < self.least_m:
                self.least_m, self.at_s = nearest, self._world.now_ns * 1e-9

    def _shapes(self, side: str) -> list[int]:
        model = self._world._plant.model
        return [k for k in range(model.ngeom) if model.body(model.geom_bodyid[k]).name.startswith(f"{side}.")]


def moved_run(prepared: Preparation, seed: int, *, with_clearance: bool) -> tuple[bool, Clearance]:
    """One run with every box moved by up to a millimetre: whether the lamp lit, and how near the arms came."""
    files, _ = gather_world("boxes", open_site([], {}, None))
    assert files is not None
    world = FileWorld(files, seed)
    server = Silent()
    driver = VirtualDriver(("rt0",), server.tell, worlds=lambda _name: world)
    program = RuntimeProgram(server, driver, ModuleFacts(), ("rt0",))
    program.applications.take("", prepared)
    program.applications.begin("", request.Begin(watch=("LAMP",)))
    clearance = Clearance(world)
    while server.result is None:
        program.advance(0 if with_clearance else 1_000_000_000)
        if with_clearance:
            clearance.look()
    return server.result.completed and server.result.values["LAMP"] == 1, clearance


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seeds", type=int, default=10)
    given = parser.parse_args()
    planned = prepare_run(APPLICATION, open_site([], {}, None))
    assert planned.plan is not None, planned.faults
    prepared = prepare(planned.plan, planned.targets, ModuleFacts())
    recorder = Recorder()
    real_step, file_world.mj_step = file_world.mj_step, recorder
    whole_run(prepared)
    file_world.mj_step = real_step
    still_garbage()  # as in the runtime itself
    speeds, ratios = [], []
    for _ in range(given.rounds):
        took, result = whole_run(prepared)
        speeds.append(result.runtime_s / took)
        ratios.append(took / recorder.replay())
    speed, ratio = statistics.median(speeds), statistics.median(ratios)
    print(f"two arms      {speed:.1f}x real time ({LEAST_SPEED:g} asked for), median of {given.rounds} rounds")
    print(f"              {ratio:.2f}x their own physics ({MOST_PHYSICS:g} at most)")
    runs = [moved_run(prepared, seed, with_clearance=seed == 0) for seed in range(given.seeds)]
    lit = sum(is_lit for is_lit, _ in runs)
    print(f"boxes moved   {lit} of {len(runs)} lamps lit with boxes up to a millimetre elsewhere")
    print(f"arms          {runs[0][1].least_m * 1e3:.0f} mm apart at the nearest, at {runs[0][1].at_s:.2f} s")


if __name__ == "__main__":
    main()
