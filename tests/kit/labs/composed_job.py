"""Jobs that are put together at random, by the ports of modules that know no robot, for an arm that is given."""

import random
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from kit.labs.laboratory import Laboratory, job, target
from kit.labs.varied_job import placed
from onika.model.syntax import Syntax
from onika.model.task import Task
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.words.value import ValueType

_SUBJECTS = ("generic", "motions", "control", "arms", "signals", "sensors", "mobile")
_ELSEWHERE = ("stewart_inv", "stewart_fwd", "jplay", "teach", "jog", "jjog")
"""Tasks of a plate with six legs, of files, and of a hand at a pad."""
_FAULTS = ("delay", "noise", "drop_out", "stuck", "lost_link", "slow_drift")
_SHAPING = ("fence", "ratelimit", "override")
_MOST_NEEDED = 8
_MOST_BESIDE = 4


@dataclass(frozen=True)
class ComposedJob:
    """An application with one action, whose job nobody has seen before."""

    program: Path
    script: Path
    tasks: tuple[str, ...]


class Composer:
    """Puts jobs together; the same seed puts together the same one."""

    def __init__(self, site: Site, syntax: Syntax, seed: int) -> None:
        self._site, self._syntax, self._random = site, syntax, random.Random(seed)
        self._pool = [task for name in _names() if (task := self._task(name)) and not task.more_targets]
        self._triggers = {task.name for task in self._pool if _is_trigger(task.module)}

    def job(self, path: Path, hardware: str, limits: Sequence[tuple[float, float]]) -> ComposedJob:
        """A job for this hardware task, and a program of it, in a base directory at `path`.

        limits   of each joint, rad, m where it slides
        """
        arm = self._task(hardware)
        assert arm is not None
        lines: dict[str, list[str]] = {hardware: []}
        chosen = self._needed(arm)
        if "Q_REF" in arm.inputs and self._random.random() < 0.4:
            chosen, own = self._shaped(chosen)
            lines |= own
        chosen += self._beside([arm, *chosen])
        if self._random.random() < 0.4:
            fault = self._task(self._random.choice(_FAULTS))
            assert fault is not None
            lines[hardware].append("SVARALIAS   Q_MEZ = Q_TRUE")
            chosen.insert(0, fault)
        trigger = next((task for task in chosen if task.name in self._triggers), None)
        if trigger is None:
            trigger = self._task("pause")
            assert trigger is not None
            chosen.append(trigger)
        lab = Laboratory(path)
        blocks = [placed(task.name, task.frequency or 50.0, *lines.get(task.name, ())) for task in [arm, *chosen]]
        (path / "conf").mkdir(parents=True, exist_ok=True)
        (path / "conf" / "triedC.conf").write_text("\n".join(["VERSION     2.0\n", *blocks, "EOF\n"]))
        kind = trigger.object_type or "Complete job"
        icons = [job("triedC", kind)]
        of_target = self._syntax.target_type_of(kind)
        if of_target:
            icons.append(target("there", of_target, *self._values(of_target, limits)))
        script = path / "ends.txt"
        script.write_text("wait 4\nabort\n")
        return ComposedJob(lab.application("tried", icons), script, tuple(task.name for task in [arm, *chosen]))

    def _task(self, name: str) -> Task | None:
        opened, faults = self._site.task(name)
        return opened.task if opened and not faults else None

    def _needed(self, arm: Task) -> list[Task]:
        """Who writes what the arm reads, and who writes what these read."""
        for _ in range(200):
            tasks = self._complete(arm)
            if tasks is not None:
                return tasks
        raise AssertionError(f"no job is found for {arm.name}")

    def _complete(self, arm: Task) -> list[Task] | None:
        tasks: list[Task] = []
        while missing := sorted(_missing([arm, *tasks])):
            able = [task for task in self._pool if missing[0] in task.outputs and self._goes_with(task, [arm, *tasks])]
            if not able or len(tasks) == _MOST_NEEDED:
                return None
            tasks.append(self._random.choice(able))
        return tasks

    def _goes_with(self, task: Task, tasks: Sequence[Task]) -> bool:
        outputs = set().union(*(other.outputs for other in tasks))
        is_second = task.name in self._triggers and any(other.name in self._triggers for other in tasks)
        is_there = any(other.module == task.module for other in tasks)
        return not (is_second or is_there or task.outputs & outputs or task.needed_at_start - outputs)

    def _shaped(self, tasks: list[Task]) -> tuple[list[Task], dict[str, list[str]]]:
        """With something between who writes the reference and the arm."""
        shaping = self._task(self._random.choice(_SHAPING))
        writer = next(task for task in tasks if "Q_REF" in task.outputs)
        others = [task for task in tasks if task is not writer and {"Q_REF", "Q^_REF"} & (task.outputs | task.inputs)]
        if shaping is None or others or shaping.module == writer.module:
            return tasks, {}
        pins = [pin for pin in writer.kinds() if dict(writer.aliases).get(pin, pin) in ("Q_REF", "Q^_REF")]
        own = [f"SVARALIAS   {pin} = {dict(writer.aliases).get(pin, pin).replace('REF', 'WISH')}" for pin in pins]
        return [shaping, *tasks], {writer.name: own}

    def _beside(self, tasks: Sequence[Task]) -> list[Task]:
        """Further tasks that read what there is."""
        beside: list[Task] = []
        for task in self._random.sample(self._pool, len(self._pool)):
            there = [*tasks, *beside]
            outputs = set().union(*(other.outputs for other in there))
            is_fit = self._goes_with(task, there) and task.name not in self._triggers and task.inputs <= outputs
            if is_fit and task.name not in _FAULTS and self._random.random() < 0.3:
                beside.append(task)
            if len(beside) == _MOST_BESIDE:
                break
        return beside

    def _values(self, kind: str, limits: Sequence[tuple[float, float]]) -> list[str]:
        """Values that may be meant, and some that cannot be."""
        found = self._syntax.find(kind)
        assert found is not None
        return [self._words(item.name, item.type, item.count, limits) for item in found.items]

    def _words(self, name: str, kind: ValueType, count: int, limits: Sequence[tuple[float, float]]) -> str:
        draw = self._random
        if kind is ValueType.INT:
            return " ".join(str(draw.randint(0, len(limits))) for _ in range(count))
        if kind is not ValueType.DOUBLE:
            return "nothing"
        if name == "endpoint":
            beyond = draw.choice((0.0, 0.0, 0.0, 0.2))
            return " ".join(f"{draw.uniform(low - beyond, high):.4f}" for low, high in limits)
        if name == "pose":
            place = draw.uniform(0.3, 0.7), draw.uniform(-0.3, 0.3), draw.uniform(-0.3, 0.6)
            return "0 0 -1 -1 0 0 " + " ".join(f"{number:.3f}" for number in place)
        return " ".join(f"{draw.uniform(0.1, 3.0):.4f}" for _ in range(count))


def _missing(tasks: Sequence[Task]) -> set[str]:
    """What some of them read and none of them writes."""
    inputs = set().union(*(task.inputs for task in tasks))
    return inputs - set().union(*(task.outputs for task in tasks))


def _names() -> list[str]:
    """The tasks that know no robot, but those that have to do with the outside, and hardware."""
    names = [path.stem for subject in _SUBJECTS for path in (shipped() / subject / "module").glob("*.rmod")]
    texts = {name: next(shipped().glob(f"*/module/{name}.rmod")).read_text() for name in names}
    return sorted(
        name for name, text in texts.items() if name not in _ELSEWHERE and not {"DEVICE", "PARTNER"} & {*text.split()}
    )


def _is_trigger(module: str) -> bool:
    return "trigger = True" in next(shipped().glob(f"*/module/{module}.py")).read_text()
