"""What modules of arms answer before anything moves: reach, poses and postures, the same for all (decision 5)."""

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

from onika.laws import reach
from onika.laws.arm_identity import Identity, arm_constants, driven_otherwise
from onika.laws.frames import Array, Numbers
from onika.laws.sentence import LawSentence


class ArmReach:
    """Stands before `Module` among the classes of a module whose OUTCONSTs describe an arm."""

    @classmethod
    def resolve(cls, constants: Mapping[str, Any], targets: Sequence[tuple[str, Sequence[Any]]]) -> list[str | None]:
        """Why a joint target lies beyond a limit or a pose has no posture; None for what can be reached."""
        return reach.why_not(constants, targets)

    @classmethod
    def poses(cls, constants: Mapping[str, Any], targets: Sequence[Numbers]) -> list[Array]:
        """The Cartesian targets that joint targets are."""
        return reach.poses(constants, targets)

    @classmethod
    def postures(cls, constants: Mapping[str, Any], poses: Sequence[Numbers]) -> list[Any]:
        """The joint targets that Cartesian targets are, each nearest to the one before, or why there are none."""
        return reach.postures(constants, poses)


class DescribedArm(ArmReach):
    """The same of an arm that its device describes."""

    driven_by: ClassVar[str] = ""
    """What a command to its device consists of: position, velocity or torque."""

    @classmethod
    def constants(cls, local: object, identity: Identity) -> dict[str, Any]:
        """Everything that is known of an arm, by the names of the OUTCONSTs, as its device says it."""
        return arm_constants(identity)

    @classmethod
    def fits(cls, constants: Mapping[str, Any] | None, local_values: Identity) -> LawSentence | None:
        """Why the device that says this of itself takes other commands."""
        return driven_otherwise(local_values, cls.driven_by)
