"""A pad: the variable by which a person leads a tool, whatever the person holds in the hand (K07)."""

NAME = "PAD"
"""The variable that no task writes: whoever holds the subsystem writes it, push by push."""

COUNT, HELD, SCALE, FRAME, BUTTON, AXES = 0, 1, 2, 3, 4, 5
"""What stands where: how many pushes there were, dead-man, share of the speed, frame, button; from here the axes."""

FRAMES = ("world", "tool", "base")
"""Along whose axes a push is meant; FRAME is a place in this row."""

SIZE = AXES + 6
"""Elements of the variable, each a double: three axes of moving, three of turning, -1..1."""
