"""The joint values with which an arm's tool comes to poses, as its module says; nothing lives for it, nothing moves."""

from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_form import wrong_code
from onika.wire import live, request
from onika.words.fault import Fault
from onika.words.reason import NOTHING, Reason


def solve(message: live.Solve, loading: ModuleQuestions) -> live.Solved | request.Refused:
    """Joint values for each pose, or why there are none."""
    malformed = wrong_code([message.code])
    if malformed:
        return request.Refused(malformed[0].sentence)
    constants = loading.constants(message.code, message.local)
    if isinstance(constants, Fault):
        return request.Refused(constants.sentence)
    postures = loading.postures(message.code, constants, [list(pose) for pose in message.poses])
    if isinstance(postures, Fault):
        return request.Refused(postures.sentence)
    if postures is None:
        return request.Refused(Reason.of("host.no_poses", module=message.code.module))
    return live.Solved(
        tuple(() if isinstance(posture, Reason) else tuple(posture) for posture in postures),
        tuple(posture if isinstance(posture, Reason) else NOTHING for posture in postures),
    )
