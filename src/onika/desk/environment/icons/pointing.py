"""A place of a workcell becomes the values of a target: the arm's module says with which joints it is reached (D25).

Where the tool points is given, how it is turned about that direction is not: of all turns the arm takes the first that
it reaches. Nothing lives for it, and nothing moves.
"""

from collections.abc import Sequence

from msgspec import structs

from onika.desk.environment.icons.meant_arms import arms_meant
from onika.desk.environment.icons.measured_variables import measures_of
from onika.desk.environment.icons.program_arms import MeasuringTasks
from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.target_items import items_of
from onika.desk.plan.icon_names import a_kind, kind_named
from onika.model.pose_numbers import aimed
from onika.wire import act, live
from onika.wire.view import ItemView, TaughtView
from onika.words.reason import NOTHING, Reason

Pose = tuple[float, ...]


def point(model: Model, command: act.PointAt, outside: Services) -> Procedure:
    """Ask for a place as values; the value is a `view.TaughtView`."""
    kind = model.syntax.find(command.type) if model.syntax else None
    item = next((item for item in items_of(model, command.type) if item.place), None)
    if kind is None or item is None:
        return No(Reason.of("desk.no_place", kind=a_kind(kind.name) if kind else kind_named(command.type)))
    if not any(command.approach):
        return No(Reason.of("desk.no_approach"))
    poses = aimed(command.position, command.approach, command.normal)
    arms = _arms_there(arms_meant(model, command, measures_of(model, kind), outside), command.world)
    if not arms:
        return _unjudged(model, item, poses, kind.name)
    arm = next((arm for arm in arms if arm.arm == command.arm), arms[0])
    names = tuple(sorted(each.arm for each in arms))
    made_for = arm.made_for if item.place == "joints" else ""
    view = TaughtView({}, NOTHING, type=kind.name, arm=arm.arm, device=min(arm.devices), arms=names, made_for=made_for)
    return (yield from _reached(model, arm, item, poses, view))


def _arms_there(arms: Sequence[MeasuringTasks], world: str) -> list[MeasuringTasks]:
    """The arms that stand in a world."""
    return [arm for arm in arms if any(device.partition(":")[0] == world for device in arm.devices)]


def _unjudged(model: Model, item: ItemView, poses: Sequence[Pose], kind: str) -> Done | No:
    """A pose is one for whatever arm; the values of joints are those of a certain arm."""
    if item.place == "joints":
        return No(Reason.of("desk.no_arm_there"))
    source = Reason.of("desk.place_unjudged")
    return Done(model, value=TaughtView({item.name: poses[0]}, source, type=kind))


def _reached(model: Model, arm: MeasuringTasks, item: ItemView, poses: tuple[Pose, ...], view: TaughtView) -> Procedure:
    """The first pose that the arm reaches, or why it reaches none."""
    code = next(code for code in arm.code if code.digest == arm.driver.digest)
    model, response = yield Ask(model, live.Solve(code, arm.driver.local, poses), RequiredRuntime())
    if not isinstance(response, live.Solved):
        return No(refusal(response))
    pairs = zip(poses, response.joints, strict=True)
    pose, joints = next(((pose, joints) for pose, joints in pairs if joints), ((), ()))
    if not joints:
        return No(Reason.of("desk.place_beyond", arm=arm.arm, why=response.reasons[0]))
    values = {item.name: pose if item.place == "pose" else joints}
    source = Reason.of("desk.place_reached", arm=arm.arm)
    return Done(model, value=structs.replace(view, values=values, source=source, joints=joints))
