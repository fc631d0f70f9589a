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
    found = [mark for at, _, one in review.events if (mark := _of_event(run, at * 1e-9, one)) is not None]
    found += [_of_command(run, at * 1e-9, one) for at, one in review.commands]
    return tuple(sorted(found, key=lambda one: one.at_s))


def _of_event(run: Run, at_s: float, one: event.Event) -> MarkView | None:
    match one:
        case event.Failed():
            return MarkView(at_s, "error", run.speech.said(f"{one.task}: {one.text}"))
        case event.Lost():
            return MarkView(at_s, "error", f"{one.name} was lost: {one.cause}")
        case event.Stopped() if one.is_stopped:
            return MarkView(at_s, "stop", f"everything was stopped: {one.cause}" if one.cause else "everything stopped")
        case event.Explained() if one.choices:
            return MarkView(at_s, "stop", run.speech.said(f"{one.subsystem}: {one.text}"))
        case event.Result() if not one.completed:
            return MarkView(at_s, "stop", run.speech.said(f"the run ended: {one.cause}"))
        case event.Met():
            return MarkView(at_s, "meet", f"{' and '.join(one.subsystems)} met at {tag(one.tag)}")
    return None


def _of_command(run: Run, at_s: float, one: request.Request) -> MarkView:
    return MarkView(at_s, "stop" if isinstance(one, request.Stop) else "command", _command(run, one))


def _command(run: Run, one: request.Request) -> str:
    match one:
        case request.Stop():
            return f"stop: {one.cause}" if one.cause else "stop"
        case request.Abort():
            return f"end the run: {one.cause}"
        case request.Reply():
            return f"answer to {one.task}: {one.line}"
        case steer.Skip():
            where = run.called(one.subsystem, one.action) if one.action is not None else "the next action"
            return f"skip to {where}: {one.subsystem}"
        case steer.Mark():
            verb = "set a breakpoint after" if one.is_set else "remove the breakpoint after"
            return f"{verb} {run.called(one.subsystem, one.action)}"
        case live.Touch():
            return f"{one.part} is {'pressed' if one.value else 'let go'}"
        case live.Set():
            return f"set {one.name} of {one.task} to {one.value}"
        case live.Clear() | live.Reinit():
            verb = "bring out of its error" if isinstance(one, live.Clear) else "begin anew"
            return f"{verb}: {one.task}"
    home = getattr(one, "subsystem", "")
    return _STEERED[type(one)] + (f": {home}" if home else "")
