"""What sessions ask of a runtime in a day's work, and the names that mean something to it, for tests that garble both.

requests = honest_requests(plans, ("mass", "servo"))
"""

from collections.abc import Sequence

from onika.wire import live, request, steer
from onika.wire.plan import Plan
from onika.words.reason import Reason


def honest_requests(plans: Sequence[Plan], tasks: tuple[str, str]) -> list[request.Request]:
    """For plans whose first flow has these two tasks, the second of them its trigger."""
    first, second = tasks
    straight = plans[0]
    planned, code = straight.flows[0].tasks, straight.code
    repeated = (request.Recorded(10**8, 0, request.encode(steer.Pause())),)
    return [
        *(request.Prepare(plan, (request.TargetValues(0, 0, "joint object", (1.0,)),)) for plan in plans),
        request.Begin(watch=("X",)),
        request.Begin(is_held=True, on_error="wait"),
        request.Begin(repeat=repeated, repeat_until_ns=10**9),
        request.Inspect(planned, code),
        request.Abort(Reason.plain("enough")),
        live.Change("s0", spawn=planned, code=code),
        live.Change("s0", on=(live.Turn(first), live.Turn(second, "1.0"))),
        live.Change("s0", off=(second,), rates=((first, 250.0),)),
        live.Change("s0", kill=(second,)),
        live.Describe(code),
        live.Solve(code[0], planned[0].local, ((0.0, 0.0, -1.0, 1.0, 0.0, 0.0, 0.4, 0.2, 0.1),)),
        live.Swap("s0", second, code[1]),
        live.Reinit("s0", first, planned[0].local),
        live.Get("s0", second, "x"),
        live.Advance(0.1),
        live.Renew(3),
        live.Read("s0"),
        live.Attend(("*",), ("s0/*",), ("yard",)),
        live.Close("s0"),
        live.Reset(),
    ]


def names_of(plan: Plan, world: str) -> dict[str, Sequence[str]]:
    """By the field's name, texts that mean something at a runtime with this plan and world."""
    tasks = tuple(task.name for task in plan.flows[0].tasks)
    variables = tuple(dict.fromkeys(name for task in plan.flows[0].tasks for name in (*task.outvar, *task.invar)))
    return {
        "subsystem": ("s0", "flow0", "flow0.0"),
        "task": tasks,
        "name": (*tasks, *variables),
        "world": (world,),
        "part": ("panic",),
        "digest": tuple(code.digest for code in plan.code),
        "source": (*(code.source for code in plan.code), "x = 1", ""),
        "module": tasks,
        "type": ("periodic", "synchronous", "aperiodic"),
        "readings": ("s0/*",),
        "condition": ("X[0] > 1", "X > 1", "Q >", "flow0/X[0] < 2"),
        "conditions": ("X[0] > 1",),
        "on_loss": ("stop", "finish", "run"),
        "on_error": ("abort", "wait"),
        "to": ("session 0", "session 1"),
    }
