import numpy as np
import pytest

from onika.model.signal import Signal, SignalKind, finish, off
from onika.runtime.modules.cycle_result import signal_of


@pytest.mark.parametrize(
    ("returned", "sentence"),
    [(finish(), "only a trigger finishes"), ("done", "found 'done'"), (Signal(SignalKind.USER, number="x"), "'str'")],
)
def test_what_is_no_signal_of_this_task_is_refused(returned, sentence):  # R-A08
    with pytest.raises(TypeError, match=sentence):
        signal_of(returned, is_trigger=False)


def test_a_trigger_finishes_its_job_and_a_passive_task_goes_off():  # R-A08
    assert signal_of(finish(2, True), is_trigger=True) == finish(2, True)
    assert signal_of(off(), is_trigger=False) == off()


def test_numbers_of_arrays_become_plain_ones():  # they travel as bytes
    signal = signal_of(finish(np.int64(2), np.bool_(True)), is_trigger=True)
    assert (type(signal.flow), type(signal.loop)) == (int, bool)
    assert signal == finish(2, True)
