import pytest

from onika.desk.run.settings import RunSettings
from onika.desk.trial.account import CompletedAction, FlowAccount, RunAccount
from onika.desk.trial.keeping import kept_of
from onika.desk.trial.variables import KeptVariable
from onika.model.kept import KeptMeeting

ARM = (
    KeptVariable("Q_MEZ", ("rad",), True, True, "puma"),
    KeptVariable("LAMP", ("-",), False, True, "led_monitor"),
    KeptVariable("Q_REF", ("rad",), True, False, "jtraj"),
)
HAND = (
    KeptVariable("GRIP_MEZ", ("m", "m/s", "N"), True, True, "gripper"),
    KeptVariable("LAMP", ("-",), False, True, "led_monitor"),
    KeptVariable("GRIP", ("-",), True, False, "shut"),
)
PLACES = {"above": 0.5, "down": 0.2, "aside": -0.7, "stack": -0.4, "elsewhere": 1.4}
WAY = ("open", "move above", "move down", "close", "move above", "move aside", "move stack", "open", "move aside")


class TrialFixture:
    """A small machine: an arm with one joint, a hand, and a lamp that is lit once a box stands on the stack."""

    def run(self, way=WAY, *, off=0.0, force=60.0, seconds=1.0, robot="puma", tag="meet", **more):
        """The account of a run of these actions; `off` is added to all that is measured."""
        passed, at, hand, where, is_held, lamp = [], 0.0, 0.03, 1.0, False, 0.0
        for name in way:
            job, _, aim = name.partition(" ")
            if job == "move":
                where = PLACES[aim]
                values = {"Q_MEZ": (where + off,), "LAMP": (lamp,), "Q_REF": (where,)}
            else:
                if job == "open" and is_held and where == PLACES["stack"]:
                    lamp = 1.0
                is_held = job == "close" and where == PLACES["down"]
                hand = 0.11 if job == "open" else 0.08 if is_held else 0.03
                sign = 1.0 if job == "open" else -1.0
                values = {"GRIP_MEZ[0]": (hand,), "GRIP_MEZ[1]": (off,), "GRIP_MEZ[2]": (force,), "GRIP": (sign,)}
                values["LAMP"] = (lamp,)
            lasts = seconds if job == "move" else 0.18
            passed.append(CompletedAction(name, at, at + lasts, ARM if job == "move" else HAND, values))
            at += lasts
        end = {"Q_MEZ": (where + off,), "LAMP": (lamp,), "GRIP_MEZ[0]": (hand,)}
        part = FlowAccount("flow0", ((robot, "boxes:arm"),), passed, end)
        fields = {"digest": "d" if way == WAY else "other", "lasted_s": at, "hash": "h"}
        return RunAccount(parts=[part], meetings=[KeptMeeting(tag, ("flow0", "flow1"))], **(fields | more))

    def kept(self, *others, settings=None, **more):
        """What is kept of its usual run."""
        return kept_of(settings or RunSettings("stack", is_virtual=True), self.run(**more), others)


@pytest.fixture
def workshop():
    return TrialFixture()
