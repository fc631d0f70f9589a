"""Creates a new module from a template: its code, its `.rmod` and its test, in a base directory."""

import keyword
from collections.abc import Mapping
from pathlib import Path

from onika.files import whole
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

LONGEST = 64

_CODE = '''\
"""{name}: says what this module does in one sentence."""

from onika.module import InVar, Local, Module, OutVar


class {title}(Module):
    """Multiplies a number by a gain.

    u = GAIN y

    Kind     general, periodic, 1..1000 Hz
    Ports    INVAR    Y        double          -       what comes in
             OUTVAR   U        double          -       what goes out
    Local    GAIN              double          -       the gain
    """

    Y = InVar("double", "-", "what comes in")
    U = OutVar("double", "-", "what goes out")
    GAIN = Local("double", "-", "the gain", default=1.0)

    def cycle(self):
        self.U = self.GAIN * self.Y
'''

_RMOD = """\
MODULE      {name}
DESC        Multiplies a number by a gain.
INCONST     none
OUTCONST    none
INVAR       Y
OUTVAR      U
TASKTYPE    periodic
FREQ        100

LOCAL
GAIN        2.0

EOF
"""

_TEST = '''\
"""What {name} does, on the bench: no runtime, no robot."""

from pathlib import Path

from onika.testing.bench import Bench

MODULE = Path(__file__).parent.parent / "module" / "{name}.py"


def test_{identifier}_multiplies_by_its_gain():
    bench = Bench(MODULE, frequency=100, local={{"GAIN": "3"}})
    bench["Y"] = 2.0
    bench.init().on().cycle()
    assert bench["U"] == 6.0
'''


def create_module(name: str, base: Path) -> tuple[Path, ...]:
    """Write the three files; raises ValueError with a sentence where the name is none or a file is there already."""
    title = judged_name(name)
    files = {
        base / "module" / f"{name}.py": _CODE,
        base / "module" / f"{name}.rmod": _RMOD,
        base / "tests" / f"test_{name}.py": _TEST,
    }
    return written_new({path: text.format(name=name, title=title, identifier=name) for path, text in files.items()})


def judged_name(name: str) -> str:
    """The name of the class of a module of this name; raises ValueError for what is no name of one."""
    if not TASK_NAME.match(name) or not name.isidentifier() or keyword.iskeyword(name) or len(name) > LONGEST:
        raise ValueError(Reason.of("desk.module_name", longest=LONGEST, name=name))
    return "".join(part.capitalize() for part in name.split("_"))


def written_new(files: Mapping[Path, str]) -> tuple[Path, ...]:
    """Write files where there are none; raises ValueError where one is there already, and then writes none."""
    for path in files:
        if path.exists():
            raise ValueError(Reason.of("desk.file_there", path=str(path)))
    for path, text in files.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        written = whole.write(path, text, whole.ABSENT)
        if isinstance(written, Refusal):
            raise ValueError(written.reason)
    return tuple(files)
