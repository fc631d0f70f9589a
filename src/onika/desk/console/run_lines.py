"""Console commands that run applications: run, begin, abort, home, calibrate (requirement A16, §E.1)."""

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.site_library import SiteLibrary
from onika.desk.console.time_lines import ended, until_asked
from onika.desk.plan import begin_places
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.preparation import prepare_run
from onika.model.planned import task_of
from onika.model.redirect import Redirect
from onika.wire import request
from onika.wire.plan import Plan
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of

Words = tuple[str, ...]
HOME = "go_home"
CALIBRATE = "calibrate"
OFF = "Q_OFF"
"""The variable that tells how far joints are off; read at the end of a calibration."""


def run(session: ConsoleSession, words: Words) -> Faults:
    """Begin an application; in a script, go on to its end, or to a question, which the next line may answer."""
    return _to_its_end(session, begin(session, words))


def _to_its_end(session: ConsoleSession, faults: Faults) -> Faults:
    if faults or not session.in_script:
        return faults
    faults = until_asked(session)
    if faults or session.running:
        return faults
    return ended(session)


def begin(session: ConsoleSession, words: Words) -> Faults:
    """Begin an application, and go on with the next line at once, in a script too."""
    return _begun(session, words)


def _begun(session: ConsoleSession, words: Words, watch: Words = ()) -> Faults:
    """Begin an application; of the variables to watch those that its tasks write are told at its end."""
    if session.running:
        return session.no(Reason.of("console.one_runs_already", name=session.running))
    try:
        redirects = tuple(Redirect.parse(word) for word in words[1:] if not _is_place(word))
    except ValueError as wrong:
        return (Fault(Place("line"), reason_of(wrong), Reason.of("words.nothing_run")),)
    prepared = prepare_run(words[0], session.site, redirects)
    for note in prepared.notes:
        session.say(Reason.of("console.note", text=note.sentence), Tone.NOTE)
    if prepared.faults or prepared.plan is None:
        return prepared.faults
    try:
        plan = _begun_at(prepared.plan, tuple(filter(_is_place, words[1:])))
    except ValueError as wrong:
        return session.no(reason_of(wrong), Reason.of("words.nothing_run"))
    faults = session.order(request.Prepare(plan, prepared.targets))
    on_error = "abort" if session.in_script else "wait"
    faults = faults or session.order(request.Begin(_written(prepared.plan, watch), may_ask=True, on_error=on_error))
    if faults:
        return faults
    session.running, session.result = prepared.name, None
    session.flow_index = FlowIndex.of(prepared.plan)
    session.running_in = frozenset(flow.subsystem for flow in prepared.plan.flows)
    total = sum(len(flow.actions) for flow in prepared.plan.flows)
    session.say(Reason.of("console.actions", name=prepared.name, count=total), Tone.HEAD)
    return ()


def _is_place(word: str) -> bool:
    """Whether a word says where a flow begins, as `flow0@7`."""
    return "@" in word and "=" not in word


def _begun_at(plan: Plan, words: Words) -> Plan:
    """The plan whose flows begin at these actions, each `FLOW@N`; raises ValueError that says what was expected."""
    index, places = FlowIndex.of(plan), dict[str, int]()
    for word in words:
        name, _, action = word.partition("@")
        subsystem = index.flow(name) if name else index.lone
        flow = next((flow for flow in plan.flows if flow.subsystem == subsystem and flow.parent is None), None)
        if flow is None:
            raise ValueError(Reason.of("console.begins_at", word=word, flows=index.subsystems))
        places[subsystem] = begin_places.entry(flow, index.action(subsystem, action))
    return begin_places.begun_at(plan, places)


def abort(session: ConsoleSession, words: Words) -> Faults:
    """End the run: tasks off, drives in hold."""
    is_there = session.running or any(subsystem.application for subsystem in session.look_again().subsystems)
    if not is_there:
        return session.no(Reason.of("console.no_application_runs"))
    cause = Reason.plain(" ".join(words)) or Reason.of("desk.aborted_by_user")
    faults = session.order(request.Abort(cause))
    if not session.running:  # one that somebody left alone
        session.hear()
        return faults
    return faults or session.until(lambda: not session.running, Reason.of("console.end_of_run"))


def home(session: ConsoleSession, words: Words) -> Faults:
    """Run the application `go_home`."""
    del words
    return run(session, (HOME,))


def calibrate(session: ConsoleSession, words: Words) -> Faults:
    """Run the application `calibrate_ROBOT`, or `calibrate`, of the laboratory."""
    name = f"{CALIBRATE}_{words[0]}" if words else CALIBRATE
    if name in SiteLibrary(session.site, session.place).applications:
        return _to_its_end(session, _begun(session, (name,), (OFF,)))
    return session.no(Reason.of("console.no_calibration", name=name))


def _written(plan: Plan, names: Words) -> Words:
    """Those of the variables that tasks of a flow write, by their addresses."""
    written = {flow.subsystem: {svar for task in flow.tasks for svar in task_of(task).outputs} for flow in plan.flows}
    return tuple(f"{subsystem}/{name}" for subsystem, svars in written.items() for name in names if name in svars)
