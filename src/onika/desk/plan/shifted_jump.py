"""An instruction in a program before which others have come: what it jumps to lies so many places later."""

from msgspec import structs

from onika.wire.plan import Again, Choose, Instruction, Jump, Unless


def shifted(instruction: Instruction, by: int) -> Instruction:
    """The instruction so many places later; flows that it names stay as they are."""
    match instruction:
        case Choose():
            return structs.replace(instruction, to=tuple(place + by for place in instruction.to))
        case Again() | Unless() | Jump():
            return structs.replace(instruction, to=instruction.to + by)
    return instruction
