"""The functions in C called one after the other by a loop in Python: what the modules in C do beside Onika."""

from ctypes import c_double, c_void_p
from time import perf_counter_ns

import numpy as np

from beside.contestant import Figures, serve
from beside.loop.blocks import BLOCKS, SIZE, STEP_S, path
from beside.loop.c_library import function, place


def main() -> None:
    """The contestant."""
    wanted, wanted_rate, found, found_rate, asked = np.zeros((5, SIZE))
    old = path(0.0)
    follow, differ, control, move = (
        function("path", c_double, c_void_p), function("derivative"), function("torque"), function("moved"),
    )  # fmt: skip
    following = place(wanted)
    differing = place(wanted), place(old), place(wanted_rate)
    controlling = place(wanted), place(wanted_rate), place(found), place(found_rate), place(asked)
    moving = place(asked), place(found), place(found_rate)
    done = 0

    def measure(steps: int) -> Figures:
        nonlocal done
        began = perf_counter_ns()
        for step in range(done, done + steps):
            follow(step * STEP_S, following)
            differ(*differing)
            control(*controlling)
            move(*moving)
        took = perf_counter_ns() - began
        done += steps
        return {"figure": took / 1e3 / steps / BLOCKS, "steps": done, "position": found.tolist()}

    serve("ctypes", measure)


if __name__ == "__main__":
    main()
