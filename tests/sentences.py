"""What the English of a fault says that was expected and found: tests may look at words, programs look at its key."""

from onika.wire.request import FaultText
from onika.words.fault import Fault


def expected_by(fault: Fault | FaultText) -> str:
    """What was expected."""
    return str(fault.reason).removeprefix("expected ").partition(", found ")[0]


def found_by(fault: Fault | FaultText) -> str:
    """What was found."""
    return str(fault.reason).partition(", found ")[2]
