"""What stands where in the variable of a pad: the shipped module reads it so."""

import numpy as np

from onika.model import pad
from onika.store.shipped import shipped
from onika.testing.bench import Bench


def test_the_shipped_module_reads_a_pad_as_it_is_written():  # R-K07
    bench = Bench(shipped() / "motions" / "module" / "pad.py", constants={"BASE": np.diag([-1.0, -1.0, 1.0, 1.0])})
    row = np.zeros(pad.SIZE)
    bench.init()["PAD"] = row
    bench.on()
    row[pad.COUNT] = 1.0
    bench["PAD"] = row
    bench.cycle()
    row[[pad.COUNT, pad.HELD, pad.SCALE, pad.BUTTON]] = 2.0, 1.0, 0.5, 1.0
    row[pad.FRAME] = pad.FRAMES.index("base")
    row[pad.AXES], row[pad.AXES + 5] = 1.0, -1.0
    bench["PAD"] = row
    bench.cycle()
    assert np.allclose(bench["V_REF"], [-0.05, 0, 0, 0, 0, -0.25])
    assert bench["BUTTONS"] == 1
