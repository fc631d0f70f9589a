"""The teaching application of the thesis: an arm is led by a pad from each approach point (requirement K07)."""

import numpy as np
import pytest

from onika.desk.run.run import start
from onika.desk.run.settings import RunSettings
from onika.store.site import open_site

pytestmark = pytest.mark.site

PERIOD_S = 0.05


def test_led_by_a_pad_the_tool_goes_where_it_is_pushed_and_rests_within_250_ms_of_the_last_push():  # R-K07, R-F05
    def place():
        return np.array(running.read("X_MEZ"))[:3, 3]

    def stroke(line, times):
        for word in ("pad free", *[line] * times):
            assert running.steer(word) == ()
            running.wait(str(PERIOD_S))

    with start(RunSettings("teach_by_pad", is_virtual=True), open_site([], {}, None)) as running:
        running.wait("began 2")
        start_place = place()
        stroke("pad 0 0 -1", 20)
        led = place() - start_place
        assert led == pytest.approx([0, 0, -0.093], abs=0.006)  # the first tenth of a second it gathers speed
        running.wait("0.2")  # nothing is let go: nothing comes any more, the last push is 0.25 s old
        rest, wanted = place(), running.read("Q_REF")
        running.wait("0.5")
        assert running.read("Q_REF") == pytest.approx(wanted, abs=1e-12)
        assert np.linalg.norm(place() - rest) < 1.5e-3  # what the servo still makes good
        assert rest[2] - start_place[2] > -0.125
        stroke("pad 1 0 0", 4)
        assert running.steer("pad free") == ()
        running.wait("0.3")
        assert place()[0] > rest[0] + 0.005
        for _ in range(10):
            running.steer("pad press")
            running.wait(str(PERIOD_S))
        assert running.wait("began 4") == ()


def test_a_tool_that_is_led_out_of_reach_rests_there_and_is_led_back():  # R-K07, R-F05
    with start(RunSettings("teach_by_pad", is_virtual=True), open_site([], {}, None)) as running:
        running.wait("began 2")
        for line, times in (("pad 1 0 1 0 0 1", 160), ("pad -1 0 -1", 60)):
            for word in ("pad free", *[line] * times):
                assert running.steer(word) == ()
                running.wait(str(PERIOD_S))
            place = np.array(running.read("X_MEZ"))[:3, 3]
            if line.startswith("pad 1"):
                furthest = place
        assert furthest[0] > 0.7 and place[0] < furthest[0] - 0.1  # the job goes on all the while
        running.steer("pad free")
        running.wait("0.3")
        for _ in range(10):
            running.steer("pad press")
            running.wait(str(PERIOD_S))
        assert running.wait("began 4") == ()
