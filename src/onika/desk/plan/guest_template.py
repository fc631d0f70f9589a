"""Creates a guest from a template: its program, the tasks that start and ask it, a job, a test (requirement A20)."""

import shlex
from pathlib import Path

from onika.desk.plan.module_template import judged_name, written_new

_PROGRAM = '''\
"""{name}: says what this guest does in one sentence."""

from onika.guest import ActionResult, Errand, GuestError, GuestProgram, action


class {title}(GuestProgram):
    """A method with @action is an action; what it gives is the branch that the flow takes."""

    name = "{name}"

    @action
    def choose(self, errand: Errand) -> ActionResult:
        """The smallest of the numbers: flow 0 for the first, 1 for the second …"""
        numbers = errand.target["numbers"]
        if min(numbers) < 0:
            raise GuestError("there are no numbers below zero in my world")
        return ActionResult(flow=numbers.index(min(numbers)), says="that was easy")


if __name__ == "__main__":
    {title}().serve()
'''

_CODE = '''\
"""Has {name} choose."""

from onika.module import GuestAction, Input


class {title}Chooses(GuestAction):
    """Has the guest {name} choose the smallest number.

    Kind     trigger, synchronous, 1..100 Hz
    Local    GUEST     string     -  name of the guest
             PARTNER   line       -  where the guest listens: unix:PATH or tcp:HOST:PORT
             STARTS    line       -  what starts the guest, if the task is to do that
             PATIENCE  double     s  how long the action may take
    Input    numbers   double[3]  -  from which it chooses
    Finish   the flow that the guest chooses, loop FALSE
    Errors   no answer    ERROR: the guest is gone, refuses, or takes longer than PATIENCE
    """

    action = "choose"

    numbers = Input("double[3]", "-", "from which it chooses")
'''

_TASK = """\
MODULE      {module}
DESC        {says}
INCONST     none
OUTCONST    none
INVAR       none
OUTVAR      none
TASKTYPE    synchronous
FREQ        {frequency}

LOCAL
GUEST       {name}
PARTNER     unix:@{{runtime}}/{name}
{starts}PATIENCE    {patience}

EOF
"""

_JOB = """\
VERSION     1.3

RMODFILE    {name}
COORDS      80 100
INLEFT      yes
FREQ        2
RTPU        unknown

RMODFILE    {name}_chooses
COORDS      80 200
INLEFT      yes
FREQ        20
RTPU        unknown

EOF
"""

_TEST = '''\
"""What {name} chooses, asked on the bench as its task asks it: no runtime, no robot."""

import shlex
from pathlib import Path

from onika.testing.bench import Bench

HERE = Path(__file__).parent.parent
LOCAL = {{"GUEST": "{name}", "STARTS": f"python3 {{shlex.quote(str(HERE / 'guest' / '{name}.py'))}}", "PATIENCE": 60.0}}


def test_{name}_chooses_the_smallest():
    bench = Bench(HERE / "module" / "{name}_chooses.py", frequency=20, local=LOCAL, is_synchronous=True).init()
    try:
        bench.on("0.3 0.1 0.2").cycle()
        while bench.finished is None and not bench.why:
            bench.event()
        assert bench.finished.flow == 1
        assert bench.warnings == ["it says: that was easy"]
    finally:
        bench.kill()
'''


def create_guest(name: str, base: Path) -> tuple[Path, ...]:
    """Write the files; raises ValueError with a sentence where the name is none or a file is there already."""
    title = judged_name(name)
    program = base / "guest" / f"{name}.py"
    starts = f"STARTS      python3 {shlex.quote(str(program.absolute()))}\n"
    keeper = _TASK.format(
        name=name, module="guest", says=f"starts the guest {name}", frequency=2, starts=starts, patience="5.0"
    )
    asker = _TASK.format(
        name=name, module=f"{name}_chooses", says=f"has {name} choose", frequency=20, starts="", patience="60.0"
    )
    return written_new(
        {
            program: _PROGRAM.format(name=name, title=title),
            base / "module" / f"{name}_chooses.py": _CODE.format(name=name, title=title),
            base / "module" / f"{name}_chooses.rmod": asker,
            base / "module" / f"{name}.rmod": keeper,
            base / "conf" / f"{name}_choosesC.conf": _JOB.format(name=name),
            base / "tests" / f"test_{name}.py": _TEST.format(name=name),
        }
    )
