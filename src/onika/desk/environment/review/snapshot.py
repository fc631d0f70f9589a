"""What a recorded run was like at an instant, and what its worlds consisted of (requirement X05)."""

from collections.abc import Mapping

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.run_state.review_session import ReviewSession
from onika.desk.environment.state.model import Model
from onika.record.reader import UNREADABLE
from onika.wire import act
from onika.wire.view import InstantView
from onika.words.reason import Reason, reason_of

_FAR_S = 1e9


def glance(model: Model, command: act.Glance, _outside: Services) -> Done | No:
    """What it was like; the value is a `view.InstantView`."""
    subject = looked_at(model, of_other=command.of_other)
    if isinstance(subject, No):
        return subject
    try:
        return Done(model, value=_instant(subject, model, sane(command.at_s)))
    except UNREADABLE as wrong:
        return spoilt(subject, wrong)


def recorded_scene(model: Model, command: act.RecordedScene, _outside: Services) -> Done | No:
    """What a world consisted of; the value is as that of `act.Scene`."""
    subject = looked_at(model, of_other=command.of_other)
    if isinstance(subject, No):
        return subject
    try:
        shapes = subject.review.shapes(command.world, sane(command.at_s))
    except UNREADABLE as wrong:
        return spoilt(subject, wrong)
    if shapes is None:
        return No(Reason.of("run.no_world_recorded", world=command.world))
    return Done(model, value={"shapes": shapes})


def looked_at(model: Model, *, of_other: bool) -> ReviewedRun | No:
    """The recorded run that is meant."""
    review_session: ReviewSession | None = model.review_session
    if review_session is None:
        return No(Reason.of("run.none_looked_at"))
    return review_session.subject_of(of_other=of_other) or No(Reason.of("run.no_other_looked_at"))


def sane(at_s: float) -> float:
    """A time that is asked for, as one that a recording could have."""
    return min(max(at_s, -_FAR_S), _FAR_S)


def spoilt(subject: ReviewedRun, wrong: Exception) -> No:
    """The file is not what it was when it was opened, or was spoilt before."""
    return No(Reason.of("run.unreadable_there", name=subject.path.name, why=reason_of(wrong)))


def _instant(subject: ReviewedRun, model: Model, at_s: float) -> InstantView:
    instant = subject.review.at(at_s, with_pictures=False)
    run = subject.replay.at(at_s)
    seen = {world: instant.poses.get(world) or subject.review.first_poses(world) for world in subject.review.worlds}
    poses = {world: {"rows": rows, "lit": subject.review.lit(world, at_s)} for world, rows in seen.items() if rows}
    tasks = {**instant.tasks, **_replaced(subject, instant.tasks)}
    return InstantView(at_s, run, tasks, instant.variables, poses, _homes(subject, model))


def _replaced(subject: ReviewedRun, states: Mapping[str, str]) -> dict[str, str]:
    """What a configuration names is shown in the state of what stood for it: it wrote the same variables."""
    flows = subject.review.run.prepare.plan.flows
    stood = {
        f"{flow.subsystem}/{old.name}": f"{flow.subsystem}/{name}" for flow in flows for name, old in flow.replaced
    }
    return {old: states[name] for old, name in stood.items() if name in states}


def _homes(subject: ReviewedRun, model: Model) -> dict[str, str]:
    """By open configuration, the subsystem in which its tasks were: where most of them were, and a job of its name."""
    homes = {}
    for doc, document in model.documents.items():
        names = set(document.content.names)
        likely = [
            (
                sum(task.name in names for task in flow.tasks),
                document.name in {action.job for action in flow.actions},
                flow,
            )
            for flow in subject.review.run.prepare.plan.flows
        ]
        most = max(likely, key=lambda candidate: candidate[:2], default=None)
        if most is not None and most[0]:
            homes[doc] = most[2].subsystem
    return homes
