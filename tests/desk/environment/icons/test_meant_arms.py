from types import SimpleNamespace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.icons.meant_arms import arms_meant
from onika.desk.environment.icons.measured_variables import measures_of
from onika.desk.environment.initial_model import opened
from onika.store.site import open_site
from onika.wire import act


@pytest.fixture
def desk(tmp_path):
    site = open_site([], {}, tmp_path)
    model, _ = opened(site, None, {})
    desk = FakeRuntimeEnv(tmp_path, (), LiveRuntime(), model, site)
    desk.doc = desk.do(act.NewApplication(1))
    desk.right = desk.do(act.InsertIcon(desk.doc, "jmove_rightC", "0", 0))
    desk.left = desk.do(act.InsertIcon(desk.doc, "jmoveC", "0", 0))
    return desk


def meant(desk, **more):
    model = desk.environment.model
    command = act.Teach("Joint object", **{"doc": desk.doc} | more)
    measures = measures_of(model, model.syntax.find("Joint object"))
    return [arm.arm for arm in arms_meant(model, command, measures, SimpleNamespace(site=desk.site))]


def test_the_arm_of_the_job_before_a_place_comes_first_but_the_one_that_is_named_before_it(desk):  # R-D23, R-D25
    assert meant(desk, after=desk.left) == ["puma", "puma_right"]
    assert meant(desk, after=desk.right) == ["puma_right", "puma"]
    assert meant(desk, after=desk.left, arm="puma_right") == ["puma_right", "puma"]


def test_where_no_application_is_open_none_is_meant(desk):  # R-D25
    assert meant(desk, doc="") == []
