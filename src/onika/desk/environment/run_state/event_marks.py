"""What happened in a recorded run that is worth a mark at its time line: errors, stops, meetings, commands."""

from onika.desk.environment.run_state.run import Run
from onika.desk.environment.run_state.run_view import tag
from onika.desk.run.run_review import Review
from onika.wire import event, live, request, steer
from onika.wire.view import MarkView

_STEERED: dict[type, str] = {
    steer.Pause: "pause",
    steer.Resume: "go on",
    steer.Step: "one action",
    steer.Pass: "let pass",
    steer.Leave: "leave the loop",
    steer.Recover: "clear and repeat",
    live.Reset: "allow motion again",
    live.Change: "tasks were changed",
    live.Swap: "a module was exchanged",
    live.Close: "end the subsystem",
}


def marks(run: Run, review: Review) -> tuple[MarkView, ...]:
    """All of them, in the order of time."""
    found_marks = [mark for at, _, message in review.events if (mark := _of_event(run, at * 1e-9, message)) is not None]
    found_marks += [_of_command(run, at * 1e-9, command) for at, command in review.commands]
    return tuple(sorted(found_marks, key=lambda mark_view: mark_view.at_s))


def _of_event(run: Run, at_s: float, message: event.Event) -> MarkView | None:
    match message:
        case event.Failed():
            return MarkView(at_s, "error", run.speech.with_icons(f"{message.task}: {message.text}"))
        case event.Lost():
            return MarkView(at_s, "error", f"{message.name} was lost: {message.cause}")
        case event.Stopped() if message.is_stopped:
            return MarkView(
                at_s, "stop", f"everything was stopped: {message.cause}" if message.cause else "everything stopped"
            )
        case event.Explained() if message.choices:
            return MarkView(at_s, "stop", run.speech.with_icons(f"{message.subsystem}: {message.text}"))
        case event.Result() if not message.completed:
            return MarkView(at_s, "stop", run.speech.with_icons(f"the run ended: {message.cause}"))
        case event.Met():
            return MarkView(at_s, "meet", f"{' and '.join(message.subsystems)} met at {tag(message.tag)}")
    return None


def _of_command(run: Run, at_s: float, command: request.Request) -> MarkView:
    return MarkView(at_s, "stop" if isinstance(command, request.Stop) else "command", _command(run, command))


def _command(run: Run, command: request.Request) -> str:
    match command:
        case request.Stop():
            if command.cause:
                return f"stop: {command.cause}"
            return "stop"
        case request.Abort():
            return f"end the run: {command.cause}"
        case request.Reply():
            return f"answer to {command.task}: {command.line}"
        case steer.Skip():
            where = run.called(command.subsystem, command.action) if command.action is not None else "the next action"
            return f"skip to {where}: {command.subsystem}"
        case steer.Mark():
            verb = "set a breakpoint after" if command.is_set else "remove the breakpoint after"
            return f"{verb} {run.called(command.subsystem, command.action)}"
        case live.Touch():
            return f"{command.part} is {'pressed' if command.value else 'let go'}"
        case live.Set():
            return f"set {command.name} of {command.task} to {command.value}"
        case live.Clear() | live.Reinit():
            verb = "bring out of its error" if isinstance(command, live.Clear) else "begin anew"
            return f"{verb}: {command.task}"
    home = getattr(command, "subsystem", "")
    return _STEERED[type(command)] + (f": {home}" if home else "")
