"""All contests, and the ladders by which Onika grows; goals are those the project has set itself."""

from dataclasses import dataclass

from beside.contest import Contest, Entrant
from beside.loop.blocks import check

_PY_TREES = Entrant("py_trees, one tick", "beside.sequence.py_trees_tick", "py_trees", 1 / 2)

CONTESTS = (
    Contest(
        key="loop",
        title="Loop of four blocks, vectors of six, step of 1 ms, virtual time: one block's step",
        unit="us",
        ours=Entrant("Onika, NumPy modules", "beside.loop.onika_blocks"),
        peers=(
            Entrant("Drake (Python LeafSystems)", "beside.loop.drake_blocks", "drake", 1 / 2),
            Entrant("bdsim", "beside.loop.bdsim_blocks", "bdsim", 1 / 4),
            Entrant("pathsim, blocks of its library", "beside.loop.pathsim_library", "pathsim", 1 / 4),
            Entrant("pathsim, blocks of our own, leanest", "beside.loop.pathsim_blocks", "pathsim", 0.6),
        ),
        size=5000,
        quick_size=300,
        check=check,
    ),
    Contest(
        key="compiled",
        title="The same loop, its modules in C through the same ports: one block's step",
        unit="us",
        ours=Entrant("Onika, modules in C", "beside.loop.onika_c_blocks"),
        peers=(
            Entrant("Onika, NumPy modules", "beside.loop.onika_blocks"),
            Entrant("the functions in C alone, called by a loop in Python", "beside.loop.c_calls"),
        ),
        size=5000,
        quick_size=300,
        check=check,
    ),
    Contest(
        key="sweep",
        title="24 things to do, each done once: a sweep of 24 idle tasks, without logic of actions",
        unit="us",
        ours=Entrant("Onika, sweep", "beside.sequence.onika_sweep"),
        peers=(_PY_TREES,),
        size=2000,
        quick_size=50,
    ),
    Contest(
        key="application",
        title="24 actions in sequence, each finishing at once: a whole application with its 24 switches",
        unit="us",
        ours=Entrant("Onika, application", "beside.sequence.onika_application"),
        peers=(_PY_TREES,),
        size=50,
        quick_size=2,
    ),
    Contest(
        key="hop",
        title="One hop of six doubles between two processes, the receiver blocked: half a round trip",
        unit="us",
        ours=Entrant("Onika, ring and post", "beside.hop.onika_hop"),
        peers=(
            Entrant("the same calls of the system, in C", "beside.hop.c_hop"),
            Entrant("iceoryx2, publish and event", "beside.hop.iceoryx2_hop", "iceoryx2", 1.0),
            Entrant("pyzmq, PAIR over ipc", "beside.hop.zmq_hop", "pyzmq", 1 / 2),
            Entrant("Zenoh, TCP on the loopback", "beside.hop.zenoh_hop", "eclipse-zenoh", 1 / 4),
            Entrant("dora, two nodes", "beside.hop.dora_hop", "dora-rs", 1 / 4),
        ),
        size=5000,
        quick_size=100,
        extras=(("p99", "p99"),),
    ),
    Contest(
        key="punctuality",
        title="A task of 500 Hz in wall time: lateness, 99 %",
        unit="us",
        ours=Entrant("Onika, task on a processing unit", "beside.punctuality.onika_task"),
        peers=(Entrant("C, clock_nanosleep TIMER_ABSTIME", "beside.punctuality.c_loop", goal=1.2),),
        size=4000,
        quick_size=200,
        needs_fifo=True,
        extras=(("median", "median"), ("most", "most"), ("missed", "missed")),
    ),
)


@dataclass(frozen=True, slots=True)
class Ladder:
    """One figure at growing sizes, all in one process."""

    key: str
    title: str
    unit: str
    module: str
    sizes: tuple[int, ...]
    quick_sizes: tuple[int, ...]
    share: str = ""
    """A further figure, a share, that is printed in percent."""
    per_size: bool = False
    """Whether the figure per piece is printed too."""


LADDERS = (
    Ladder(
        "tasks",
        "Idle tasks on one processing unit, virtual time: cost of one cycle",
        "us",
        "beside.growth.tasks",
        (1, 8, 64, 512),
        (1, 8),
    ),
    Ladder(
        "units",
        "Processing units with 16 tasks of 1000 Hz each, wall time: cycles per second in all",
        "1/s",
        "beside.growth.units",
        (1, 2, 3, 4),
        (1, 2),
        share="missed",
        per_size=True,
    ),
    Ladder(
        "library",
        "Task files in a library, one of a hundred broken: time to open it",
        "ms",
        "beside.growth.library",
        (10, 100, 1000, 10_000),
        (10, 100),
        per_size=True,
    ),
)
