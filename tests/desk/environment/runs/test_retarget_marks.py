import pytest
from msgspec.structs import replace

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.wire import act, request


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_steps_whose_targets_another_robot_takes_by_their_poses_are_marked(play):  # R-E09, law 26
    doc = play.open([job("aC"), job("bC")])
    ask = play.runtime.ask
    resolved = request.Resolved(0, 1, "home", "scara", "puma", (0.1,), (0.2,))
    pairs = [(resolved, replace(resolved, target="there"))]

    def answered(wish):
        answer = ask(wish)
        return replace(answer, resolved=pairs[0]) if isinstance(answer, request.Prepared) else answer

    play.runtime.ask = answered
    play.run(doc)
    notes = {number: str(view.note) for number, view in play.environment.tree.applications[doc].steps.items()}
    sentence = "is re-resolved for scara, by the pose that it is for puma"
    assert notes == {"1": "", "2": f"home {sentence}; there {sentence}"}
    play.end()
    pairs[0] = ()
    play.do(act.Run(doc))
    assert {str(view.note) for view in play.environment.tree.applications[doc].steps.values()} == {""}
