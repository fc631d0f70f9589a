"""The programs of a new robot: its tasks, jobs, targets, a small application and a test (requirement X19)."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

from onika.files import appl, conf, kept, onk, rmod
from onika.files.line import show_number
from onika.files.rmod import RmodText
from onika.model import job_pictures
from onika.model.application import AppFlow, Application, Icon
from onika.model.configuration import Configuration, Placed
from onika.model.initials import drawn
from onika.model.kept import Demand, KeptAction, KeptFlow, KeptRun
from onika.model.onikon import Onikon
from onika.model.picture import Picture
from onika.model.task import LocalLine, Task
from onika.wire.robot_draft import RobotDraft
from onika.words.reason import Reason, in_language

PLACE = "stand"
"""The place of the robot in its world."""

ARM = "arm"
"""What a draft calls an arm."""

_CONSTANTS = "NDOF SCREW LINK PARENT LOAD QMIN QMAX Q^_MAX TAUMAX BASE TOOL HOME ROBOT"
_JOINT, _CARTESIAN, _LEVEL, _PLACE = "Joint", "Cartesian", "Level", "Place"  # types of the syntax
_GRIP_S = 1.5
_DRIVE_S = 6.0
_WITHIN_S = 2.0
_NEAR = 0.1  # how exactly a base stands at its start in the test (m)
_CLOSE = 0.02  # how exactly joints stand at their target in the test (rad; m)

Texts = Iterator[tuple[str, str]]


@dataclass(frozen=True, slots=True)
class RobotPrograms:
    """The programs of the robot `name`, all made of its draft."""

    name: str
    draft: RobotDraft

    @property
    def tour(self) -> str:
        """The name of the application."""
        return f"{self.name}_tour"

    def texts(self) -> Texts:
        """The files, by their paths in a base directory."""
        for task in self._tasks():
            yield f"module/{task.name}.rmod", rmod.write(RmodText(task, ""), task)
        for configuration in self._configurations():
            yield f"conf/{configuration.name}.conf", conf.write(configuration)
        icons = {icon.name: icon for icon in (*self._steps(), *self._jobs(), *self._targets())}
        for icon in icons.values():
            yield f"dict/{icon.name}.onk", onk.write(icon)
        steps = tuple(Icon(icon.as_placed()) for icon in self._steps())
        yield f"appl/{self.tour}.appl", appl.write(Application(self.tour, False, (AppFlow(steps),)))
        yield f"tests/{self.tour}.test", kept.write(self._test())

    def _tasks(self) -> Iterator[Task]:
        if self.draft.ahead:
            yield Task(
                f"{self.name}_base", "base", self._said("desk.robot_base"), outconst=("V_MAX",),
                invar=("V_BASE",), outvar=("W_MEZ", "P_TRUE"), frequency=250.0,
                local=(LocalLine("DEVICE", (self._device("base"),)),),
            )  # fmt: skip
        if self.draft.home:
            yield from self._arm_tasks()

    def _arm_tasks(self) -> Iterator[Task]:
        yield Task(
            self.name, "arm_pos", self._said("desk.robot_task"), outconst=tuple(_CONSTANTS.split()),
            invar=("Q_REF", "Q^_REF"), outvar=("Q_MEZ", "Q^_MEZ", "TAU_MEZ"), frequency=500.0,
            local=(LocalLine("DEVICE", (self._device(self.name),)),),
        )  # fmt: skip
        if not self.draft.opening:
            return
        yield Task(
            f"{self.name}_hand", "grip", self._said("desk.robot_hand"),
            invar=("OPEN_REF", "FORCE_REF"), outvar=("GRIP_MEZ",), frequency=250.0,
            local=(LocalLine("DEVICE", (self._device("gripper"),)),),
        )  # fmt: skip
        yield Task(
            f"{self.name}_fingers", "fingers", self._said("desk.robot_grip"),
            invar=("GRIP_MEZ",), outvar=("OPEN_REF", "FORCE_REF"), frequency=50.0, object_type=f"{_LEVEL} job",
            local=(LocalLine("FORCE", (show_number(self.draft.opening[2]),)),),
        )  # fmt: skip

    def _configurations(self) -> Iterator[Configuration]:
        if self.draft.ahead:
            base = Placed(f"{self.name}_base", 720, 80, frequency=250.0)
            others = (Placed("odometry", 420, 80, frequency=250.0), Placed("gopose", 120, 80, frequency=50.0))
            yield Configuration(f"drive_{self.name}C", (base, *others))
        if self.draft.home:
            yield from self._arm_configurations()

    def _arm_configurations(self) -> Iterator[Configuration]:
        arm = Placed(self.name, 420, 80, frequency=500.0)
        yield Configuration(f"jmove_{self.name}C", (arm, Placed("jtraj", 120, 80, frequency=250.0)))
        if self.draft.line:
            far = Placed(self.name, 720, 80, frequency=500.0)
            others = (
                Placed("invkin", 420, 80, frequency=250.0),
                Placed("fwdkin", 420, 300, in_left=False, frequency=250.0),
                Placed("ctraj", 120, 80, frequency=250.0),
            )
            yield Configuration(f"cmove_{self.name}C", (far, *others))
        if self.draft.opening:
            hand = Placed(f"{self.name}_hand", 420, 80, frequency=250.0)
            yield Configuration(f"grip_{self.name}C", (hand, Placed(f"{self.name}_fingers", 120, 80, frequency=50.0)))

    def _jobs(self) -> Iterator[Onikon]:
        if self.draft.ahead:
            yield self._icon(f"drive_{self.name}C", f"{_PLACE} job", "desk.robot_drive")
        if self.draft.home:
            yield self._icon(f"jmove_{self.name}C", f"{_JOINT} job", "desk.robot_jmove")
        if self.draft.line:
            yield self._icon(f"cmove_{self.name}C", f"{_CARTESIAN} job", "desk.robot_cmove")
        if self.draft.opening:
            yield self._icon(f"grip_{self.name}C", f"{_LEVEL} job", "desk.robot_grip")

    def _targets(self) -> Iterator[Onikon]:
        draft, seconds = self.draft, (self.draft.seconds,)
        if draft.ahead:
            yield self._icon(f"{self.name}_ahead", f"{_PLACE} object", "desk.robot_ahead", (draft.ahead,))
            yield self._icon(f"{self.name}_start", f"{_PLACE} object", "desk.robot_start", ((0.0, 0.0, 0.0),))
        if draft.home:
            yield self._icon(f"{self.name}_home", f"{_JOINT} object", "desk.robot_home", (draft.home, seconds))
            yield self._icon(f"{self.name}_away", f"{_JOINT} object", "desk.robot_away", (draft.away, seconds))
        if draft.line:
            line = (draft.line, (draft.line_s,))
            yield self._icon(f"{self.name}_line", f"{_CARTESIAN} object", "desk.robot_line", line)
        if draft.opening:
            yield self._icon(f"{self.name}_open", f"{_LEVEL} object", "desk.robot_opened", ((draft.opening[0],),))
            yield self._icon(f"{self.name}_closed", f"{_LEVEL} object", "desk.robot_closed", ((draft.opening[1],),))

    def _steps(self) -> Iterator[Onikon]:
        """The application: drive on, open the hand, beside home, a straight line, close the hand, home, drive back."""
        icons = {icon.name: icon for icon in (*self._jobs(), *self._targets())}
        name = self.name
        order = [f"drive_{name}C", f"{name}_ahead", f"grip_{name}C", f"{name}_open",
                 f"jmove_{name}C", f"{name}_away", f"cmove_{name}C", f"{name}_line",
                 f"grip_{name}C", f"{name}_closed", f"jmove_{name}C", f"{name}_home",
                 f"drive_{name}C", f"{name}_start"]  # fmt: skip
        yield from (icons[step] for step in order if step in icons)

    def _test(self) -> KeptRun:
        """What is demanded of the application: where the joints are in the end."""
        robots = [(self.name, self._device(self.name))] if self.draft.home else []
        robots += [(f"{self.name}_base", self._device("base"))] if self.draft.ahead else []
        robots += [(f"{self.name}_hand", self._device("gripper"))] if self.draft.opening else []
        demands = [Demand("Q_MEZ", self.draft.home, "rad", _CLOSE)] if self.draft.home else []
        demands += [Demand(f"P_TRUE[{k}]", (0.0,), "m", _NEAR) for k in range(2)] if self.draft.ahead else []
        flow = KeptFlow("flow0", tuple(robots), tuple(self._actions()), tuple(demands))
        return KeptRun(self.tour, "", (flow,))

    def _actions(self) -> Iterator[KeptAction]:
        steps = [*self._steps()]
        for job, target in zip(steps[::2], steps[1::2], strict=True):
            usual = {f"{_LEVEL} job": _GRIP_S, f"{_PLACE} job": _DRIVE_S}.get(job.type)
            within = _DRIVE_S if job.type == f"{_PLACE} job" else _WITHIN_S
            yield KeptAction(f"{job.name} {target.name}", _seconds(target) if usual is None else usual, within)

    def _icon(self, name: str, kind: str, key: str, values: tuple[tuple[float, ...], ...] = ()) -> Onikon:
        reason = self._reason(key)
        words = (("es", in_language(reason, "es")),)
        arm = self.name if kind == f"{_JOINT} object" else ""
        return Onikon(name, kind, reason.text, values, self._picture(name), words=words, arm=arm)

    def _picture(self, name: str) -> Picture:
        """The robot itself where it goes to or comes from a place, else what its hand or base does, else letters."""
        draw = self._pictures().get(name)
        return drawn(name) if draw is None else draw()

    def _pictures(self) -> dict[str, Callable[[], Picture]]:
        """Who draws which icon."""
        pictures: dict[str, Callable[[], Picture]] = {
            f"grip_{self.name}C": job_pictures.of_hand,
            f"{self.name}_open": job_pictures.of_opened,
            f"{self.name}_closed": job_pictures.of_closed,
            f"drive_{self.name}C": job_pictures.of_base,
            f"{self.name}_ahead": job_pictures.of_goal,
            f"{self.name}_start": job_pictures.of_goal_behind,
            f"{self.name}_line": job_pictures.of_goal,
        }
        if self.draft.pictures:
            home, away = self.draft.pictures
            pictures |= {f"{self.name}_home": partial(Picture, home), f"{self.name}_away": partial(Picture, away)}
            pictures[f"jmove_{self.name}C"] = partial(job_pictures.of_joints, home, away)
            pictures[f"cmove_{self.name}C"] = partial(job_pictures.of_line, away)
        return pictures

    def _said(self, key: str) -> str:
        return self._reason(key).text

    def _reason(self, key: str) -> Reason:
        return Reason.of(key, name=self.name)

    def _device(self, word: str) -> str:
        return f"{self.name}:{word}_{PLACE}"


def _seconds(target: Onikon) -> float:
    """How long the way to a target takes, its last value."""
    return float(target.values[-1][0])
