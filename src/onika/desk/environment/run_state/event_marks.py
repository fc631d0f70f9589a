"""What happened in a recorded run that is worth a mark at its time line: errors, stops, meetings, commands."""

from onika.desk.environment.run_state.run import Run
from onika.desk.environment.run_state.run_view import tag
from onika.desk.run.run_review import Review
from onika.wire import event, live, request, steer
from onika.wire.view import MarkView
from onika.words.reason import Reason

_STEERED: dict[type, Reason] = {
    steer.Pause: Reason.of("run.steer_pause"),
    steer.Resume: Reason.of("run.steer_resume"),
    steer.Step: Reason.of("run.steer_step"),
    steer.Pass: Reason.of("run.steer_pass"),
    steer.Leave: Reason.of("run.steer_leave"),
    steer.Recover: Reason.of("run.steer_recover"),
    live.Reset: Reason.of("run.steer_reset"),
    live.PutBack: Reason.of("run.steer_put_back"),
    live.Change: Reason.of("run.steer_change"),
    live.Swap: Reason.of("run.steer_swap"),
    live.Close: Reason.of("run.steer_close"),
}


def marks(run: Run, review: Review) -> tuple[MarkView, ...]:
    """All of them, in the order of time."""
    found_marks = [mark for at, _, message in review.events if (mark := _of_event(run, at * 1e-9, message)) is not None]
    found_marks += [
        _of_command(run, at * 1e-9, command) for at, command in review.commands if not isinstance(command, live.Push)
    ]
    return tuple(sorted(found_marks, key=lambda mark_view: mark_view.at_s))


def _of_event(run: Run, at_s: float, message: event.Event) -> MarkView | None:
    match message:
        case event.Failed():
            return MarkView(at_s, "error", _with_icons(run, message.task, message.text))
        case event.Lost():
            return MarkView(at_s, "error", Reason.of("run.was_lost", name=message.name, cause=message.cause))
        case event.Stopped() if message.is_stopped:
            return MarkView(at_s, "stop", _stopped(message))
        case event.Explained() if message.choices:
            return MarkView(at_s, "stop", _with_icons(run, message.subsystem, message.text))
        case event.Result() if not message.completed:
            return MarkView(at_s, "stop", run.wording.with_icons(Reason.of("run.run_ended", cause=message.cause)))
        case event.Met():
            return MarkView(at_s, "meet", Reason.of("run.met", flows=message.subsystems, tag=tag(message.tag)))
    return None


def _with_icons(run: Run, what: str, why: Reason) -> Reason:
    return run.wording.with_icons(Reason.of("run.what_why", what=what, why=why))


def _stopped(message: event.Stopped) -> Reason:
    if message.cause:
        return Reason.of("run.everything_was_stopped", cause=message.cause)
    return Reason.of("run.everything_stopped")


def _of_command(run: Run, at_s: float, command: request.Request) -> MarkView:
    return MarkView(at_s, "stop" if isinstance(command, request.Stop) else "command", _command(run, command))


def _command(run: Run, command: request.Request) -> Reason:
    match command:
        case request.Stop() if command.cause:
            return Reason.of("run.stop_why", cause=command.cause)
        case request.Stop():
            return Reason.of("run.stop")
        case request.Abort():
            return Reason.of("run.run_ends", cause=command.cause)
        case request.Reply():
            return Reason.of("run.answered", task=command.task, line=command.line)
        case steer.Skip() if command.action is not None:
            action = run.called(command.subsystem, command.action)
            return Reason.of("run.skip_to", action=action, flow=command.subsystem)
        case steer.Skip():
            return Reason.of("run.skip_to_next", flow=command.subsystem)
        case steer.Mark():
            key = "run.breakpoint_set" if command.is_set else "run.breakpoint_removed"
            return Reason.of(key, action=run.called(command.subsystem, command.action))
    return _by_hand(command)


def _by_hand(command: request.Request) -> Reason:
    """What was done to tasks and to what stands in a workcell, or how flows were steered."""
    match command:
        case live.Touch():
            return Reason.of("run.pressed" if command.value else "run.let_go", part=command.part)
        case live.Set():
            return Reason.of("run.set_value", name=command.name, task=command.task, value=command.value)
        case live.Write():
            value = " ".join(f"{value:g}" for value in command.values)
            return Reason.of("run.wrote_value", name=command.name, value=value)
        case live.AddUnit():
            return Reason.of("run.added_unit", name=command.name)
        case live.Clear():
            return Reason.of("run.brought_out", task=command.task)
        case live.Reinit():
            return Reason.of("run.begins_anew", task=command.task)
    home = getattr(command, "subsystem", "")
    steered = _STEERED[type(command)]
    if home:
        return Reason.of("run.what_why", what=steered, why=home)
    return steered
