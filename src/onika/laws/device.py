"""Why what a device says of itself is not what a task needs behind it; None where it is."""

from collections.abc import Mapping
from typing import Any

from onika.laws.sentence import LawSentence


def no_hand(local_values: Mapping[str, Any]) -> LawSentence | None:
    """Why it is no hand: another robot, or no robot at all."""
    robot = str(local_values.get("ROBOT", ""))
    if robot == "gripper":
        return None
    if not robot:
        return LawSentence("laws.hand_missing", "expected a hand behind the device, found another device")
    return LawSentence("laws.hand_other", "expected a hand behind the device, found {other}", other=robot)


def no_lamp(local_values: Mapping[str, Any]) -> LawSentence | None:
    """Why it is no lamp with a circuit: a robot, or nothing that is known."""
    if "BOXES" in local_values or "WHEN" in local_values:
        return None
    robot = str(local_values.get("ROBOT", ""))
    if not robot:
        return LawSentence("laws.lamp_missing", "expected the lamp behind the device, found none")
    return LawSentence("laws.lamp_other", "expected the lamp behind the device, found {other}", other=robot)
