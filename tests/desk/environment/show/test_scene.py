from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.wire import act


def test_a_world_is_asked_what_it_consists_of(tmp_path):  # R-C14
    duet = FakeRuntimeEnv(tmp_path)
    duet.runtime.scenes["boxes"] = {"shapes": []}
    assert duet.do(act.Scene("boxes")) == {"shapes": []}
    assert str(duet.answer(act.Scene("moon")).no.reason) == "no world moon is open"
