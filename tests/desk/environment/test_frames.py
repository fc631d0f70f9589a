import math

import numpy as np
import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.frames import FrameBuffer
from onika.model.task import Task
from onika.wire import live, page, reading


@pytest.fixture
def model(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))
    duet.connected("a")
    return duet.environment.model


def variable(value, at_s=1.0, count=1):
    return reading.encode(reading.Variable(round(at_s * 1e9), count, value))


def test_a_frame_holds_what_has_come_since_the_one_before(model):  # R-C14
    frames = FrameBuffer()
    assert frames.take() is None
    frames.put({"Untitled-1/A": variable(1.0)}, None, model)
    frames.put({"Untitled-1/A": variable(2.0, 1.5), "Untitled-1/B": variable([1, 2])}, None, model)
    assert frames.take() == page.Frame(1.0, {"c1/A": 2.0, "c1/B": [1, 2]})
    assert frames.take() is None


def test_figures_and_poses_come_with_it(model):  # R-C14
    rows = np.array([[0.1234567, 0, 0, 1, 0, 0, 0], [1, 2, 3, 0.5, 0.5, 0.5, 0.5]], "<f4").tobytes()
    figure = live.TaskFigure("Untitled-1", "a", "m", "rt0", 1, "P", 0, "ON", *[0] * 14)
    frames = FrameBuffer()
    frames.put({"world:boxes": reading.encode(reading.Poses(5, rows, ("lamp",)))}, live.Figures((figure,), {}), model)
    frame = frames.take()
    frames = [[0.12346, 0, 0, 1, 0, 0, 0], [1, 2, 3, 0.5, 0.5, 0.5, 0.5]]
    assert frame.poses == {"boxes": {"rows": frames, "lit": ("lamp",)}}
    assert frame.figures["c1/a"]["state"] == "ON"


def test_a_picture_comes_as_text_under_the_name_of_its_camera(model):  # R-F08
    frames = FrameBuffer()
    for number, file in ((3, b"old"), (4, b"new")):
        seen = reading.CameraPicture(1_500_000_000, number, file)
        frames.put({"world:bench:eye": reading.encode(seen)}, None, model)
    assert frames.take().poses == {"bench:eye": {"file": "bmV3", "number": 4, "at_s": 1.5}}


def test_what_no_document_shows_is_dropped(model):
    frames = FrameBuffer()
    frames.put({"elsewhere/A": variable(1.0)}, None, model)
    assert frames.take() is None


def test_what_is_no_number_travels_as_nothing(model):
    frames = FrameBuffer()
    frames.put({"Untitled-1/A": variable([math.nan, math.inf, 1.0])}, None, model)
    assert b"[null,null,1.0]" in page.encode(frames.take())


def test_another_runtime_begins_with_nothing(model):
    frames = FrameBuffer()
    frames.put({"Untitled-1/A": variable(1.0)}, None, model)
    frames.clear()
    assert frames.take() is None


def test_what_belongs_to_a_run_is_shown_under_its_application(tmp_path):  # R-E11, R-C14
    play = RunFixture(tmp_path)
    doc = play.open([job("aC")])
    play.run(doc)
    frames = FrameBuffer()
    figure = live.TaskFigure("flow0", "a", "m", "rt0", 1, "P", 0, "ON", *[0] * 14)
    frames.put({"flow0/A": variable(3.0)}, live.Figures((figure,), {}), play.environment.model)
    frame = frames.take()
    assert frame.values == {f"{doc}/A": 3.0, f"{doc}/flow0/A": 3.0} and frame.figures == {}
    play.alive()
    frames.put({"flow0/A": variable(4.0)}, live.Figures((figure,), {}), play.environment.model)
    frame = frames.take()
    assert frame.values == {f"{doc}/A": 4.0, f"{doc}/flow0/A": 4.0, "@flow0/A": 4.0}
    assert frame.figures["@flow0/a"]["state"] == "ON"
