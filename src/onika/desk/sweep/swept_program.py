"""What all runs of a sweep have in common, as bytes that another machine can carry out (requirement X23)."""

import msgspec
from msgspec import Struct

from onika.desk.plan.preparation import PreparedRun
from onika.desk.run.settings import RunSettings
from onika.desk.sweep.design import SweepDesign
from onika.wire.plan import Plan
from onika.wire.request import TargetValues
from onika.words.condition import Condition


class SweptProgram(Struct, frozen=True):
    """An application with its code and its worlds, and what is expected of it; no file of a library is needed.

    expectations   conditions, as they are written
    answers        task, name of an input, values
    """

    name: str
    plan: Plan
    targets: tuple[TargetValues, ...]
    expectations: tuple[str, ...]
    settle_s: float
    answers: tuple[tuple[str, str, str], ...]
    is_shaken: bool

    @classmethod
    def of(cls, design: SweepDesign, prepared: PreparedRun) -> "SweptProgram":
        """The program of a design, which was prepared without a fault."""
        if prepared.plan is None:
            raise ValueError(prepared.faults)
        settings = design.settings
        expectations = tuple(condition.text for condition in settings.expectations)
        return cls(
            prepared.name,
            prepared.plan,
            prepared.targets,
            expectations,
            settings.settle_s,
            settings.answers,
            design.is_shaken,
        )

    @property
    def design(self) -> SweepDesign:
        """How its runs are to be; without seeds."""
        settings = RunSettings(
            name=self.name,
            is_virtual=True,
            has_black_box=False,
            expectations=tuple(map(Condition.parse, self.expectations)),
            settle_s=self.settle_s,
            answers=self.answers,
        )
        return SweepDesign(settings, range(0), is_shaken=self.is_shaken)

    @property
    def prepared(self) -> PreparedRun:
        """It as something that may run."""
        return PreparedRun(self.name, None, self.plan, self.targets, ())


encode = msgspec.msgpack.Encoder().encode
decode = msgspec.msgpack.Decoder(SweptProgram).decode
