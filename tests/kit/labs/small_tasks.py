"""A laboratory of small tasks without a device, for tests that build configurations by hand.

    lab = small_laboratory(tmp_path / "bench")

`wave` is read by `calm`, `calm` by `show`; `tone` writes what `wave` writes, `swell` has its module and another name;
`gain` gives the constant that `needs` takes, `drift` writes it every cycle; `aim` asks where to; `dial` is
set by name; `sick` always fails;
`hurry` reads what `calm` writes in another unit.
"""

import re
from pathlib import Path

from kit.labs.laboratory import Laboratory

MODULES = {
    "wave": ("WAVE = OutVar('double', 'm', 'a swing')", "self.WAVE = np.sin(self.now)"),
    "tone": ("WAVE = OutVar('double', 'm', 'a swing')", "self.WAVE = 1.0"),
    "calm": (
        "WAVE = InVar('double', 'm', 'what swings')\n    CALM = OutVar('double', 'm', 'half of it')\n"
        "    SHARE = Local('double', '-', 'how much of it', default=0.5, low=0.0, high=1.0)",
        "self.CALM = self.WAVE * self.SHARE",
    ),
    "show": ("CALM = InVar('double', 'm', 'what is shown')", "self.CALM"),
    "hurry": ("CALM = InVar('double', 's', 'a time')", "self.CALM"),
    "sick": ("PULSE = OutVar('double', '-', 'a pulse')", "raise ValueError('the sensor is dead')"),
    "gain": ("GAIN = OutConst('double', '-', 'a factor')", "return"),
    "needs": ("GAIN = InConst('double', '-', 'a factor')", "self.GAIN"),
    "drift": ("GAIN = OutVar('double', '-', 'a factor that drifts')", "self.GAIN = 1.0"),
    "dial": (
        "DIAL = OutVar('double', 'm', 'what it was set to')\n    _dial = 0.0\n\n"
        "    def get(self, name):\n        return {'dial': self._dial}[name]\n\n"
        "    def set(self, name, value):\n        self._dial = float(value)",
        "self.DIAL = self._dial",
    ),
    "aim": (
        "AIM = OutVar('double', 'm', 'where to')\n"
        "    place = Input('double', 'm', 'where to go', low=-1.0, high=2.0)\n\n"
        "    def on(self, inputs):\n        self._place = inputs.place",
        "self.AIM = self._place",
    ),
}
"""Tasks without a device: what each declares, and what it does in a cycle."""

_HEAD = "import numpy as np\n\nfrom onika.module import InConst, Input, InVar, Local, Module, OutConst, OutVar\n\n\n"


def _source(name: str, declared: str, cycle: str) -> str:
    first = "    def init(self):\n        self.GAIN = 2.0\n\n" if name == "gain" else ""
    return f"{_HEAD}class Made(Module):\n    {declared}\n\n{first}    def cycle(self):\n        {cycle}\n"


def _rows(name: str, declared: str) -> str:
    kinds = {
        kind: " ".join(re.findall(rf"(\w+) = {word}\(", declared)) or "none"
        for kind, word in (("INCONST", "InConst"), ("OUTCONST", "OutConst"), ("INVAR", "InVar"), ("OUTVAR", "OutVar"))
    }
    rows = "".join(f"{kind}  {names}\n" for kind, names in kinds.items())
    return f"MODULE  {name}\nDESC  makes {name}\n{rows}TASKTYPE  periodic\nFREQ  20\n"


def small_laboratory(path: Path) -> Laboratory:
    """The base directory `path` with all of them, and configurations `pairC` and `otherC` of two each."""
    lab = Laboratory(path)
    for name, (declared, cycle) in MODULES.items():
        lab.module(name, _source(name, declared, cycle))
        lab.task(name, _rows(name, declared))
    swell = _rows("wave", MODULES["wave"][0]).replace("INCONST", "SVARALIAS  WAVE = SWELL\nINCONST")
    lab.task("swell", swell)
    lab.configuration("pairC", "wave 20", "calm 20")
    lab.configuration("otherC", "calm 20", "tone 20")
    return lab
