"""The applications of a runtime: plans that sessions have prepared, and the runs that are made of them."""

from msgspec.structs import replace

from onika.host.driver import Driver
from onika.host.loading.plan_preparation import Preparation
from onika.host.recording.runtime_recordings import RuntimeRecordings
from onika.host.run.application_run import ApplicationRun
from onika.host.run.rendezvous_links import RendezvousLinks
from onika.host.sessions.control_authority import ControlAuthority
from onika.host.subsystems.motion import Motion
from onika.host.subsystems.subsystem_registry import Subsystems, Tell
from onika.ring.segment import SharedMemoryRefused
from onika.runtime.subsystem import RunningSubsystem
from onika.wire import request
from onika.words.reason import Reason, reason_of


class ApplicationRuns:
    """Begins the run of a prepared plan, and ends it when it is through and what is recorded of it is written."""

    def __init__(
        self,
        subsystems: Subsystems,
        driver: Driver,
        authority: ControlAuthority,
        motion: Motion,
        recordings: RuntimeRecordings,
        links: RendezvousLinks,
        tell: Tell,
    ) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._authority = authority
        self._motion = motion
        self._recordings = recordings
        self._links = links
        self._tell = tell
        self._prepared: dict[str, Preparation] = {}

    def prepared(self, session: str) -> Preparation | None:
        """The plan that this session may run next."""
        return self._prepared.get(session)

    def forget(self, session: str) -> None:
        """What the session has prepared is not run any more."""
        self._prepared.pop(session, None)

    def lost(self, session: str) -> None:
        """The session is gone: nobody steers or repeats a run in its name."""
        self.forget(session)
        self._links.forget(session)
        self._subsystems.hold.release(session)
        self._subsystems.repeat.lost(session)

    def take(self, session: str, prepared: Preparation) -> None:
        """The next plan of a session to run; one with faults leaves nothing to run."""
        self.forget(session)
        if not prepared.faults:
            self._prepared[session] = prepared

    def begin(self, session: str, message: request.Begin) -> request.Response:
        """Start a run of the session's plan on empty, zeroed tables (law 4)."""
        prepared = self._prepared.get(session)
        if prepared is None:
            return request.Refused(Reason.of("host.no_plan"))
        refusal = self._refusal(session, prepared) or self._subsystems.repeat.objection(message, self._driver.now)
        refusal = refusal or self._links.objection(session, message.meets)
        refusal = refusal or self._recordings.recorder.begin(session, message, prepared)
        if refusal:
            return request.Refused(refusal)
        about = self._recordings.descriptions.describe(session, message)
        try:
            running = self._running_subsystems(prepared)
        except SharedMemoryRefused as refused:
            self._recordings.recorder.give_up()
            return request.Refused(reason_of(refused))
        self._recordings.descriptions.began()
        if not self._subsystems.runs:
            self._driver.begin()
        tell: Tell = self._tell
        if message.is_held and self._driver.is_virtual:
            tell = self._subsystems.hold.begin(session, prepared.plan.flows[0].subsystem, self._driver.now)
        homes = tuple(flow.subsystem for flow in prepared.plan.flows)
        self._subsystems.repeat.begin(session, message, self._driver.now, homes)
        rendezvous = self._links.begin(session, message.meets, self._driver)
        run = ApplicationRun(
            session, prepared, message, running, self._driver, tell, self._subsystems.lost_units, rendezvous
        )
        if self._recordings.black_box is not None and about is not None:
            self._recordings.black_box.begin(run, about)
        self._subsystems.perform(run)
        self._authority.began(session)
        return request.Done()

    def end(self, run: ApplicationRun) -> None:
        """Tell the result, as soon as what is recorded of the run is written."""
        result = run.result(self._driver.digest, self._driver.outside)
        black_box = self._recordings.end(run, result)
        if black_box is None:
            return
        self._subsystems.runs.remove(run)
        self._links.end(run.runner.rendezvous, self._driver.now)
        self._subsystems.hold.release(run.session)
        self._subsystems.repeat.end(run.names)
        run.end(replace(result, black_box=black_box))

    def _refusal(self, session: str, prepared: Preparation) -> Reason:
        """Why no run of this plan may begin now."""
        occupied = self._authority.occupied(session, [flow.subsystem for flow in prepared.plan.flows])
        return occupied or self._motion.refusal(task.rtpu for flow in prepared.plan.flows for task in flow.tasks)

    def _running_subsystems(self, prepared: Preparation) -> dict[int, RunningSubsystem]:
        """The subsystems of a run that begins, by the number of their flow."""
        running = {}
        for number, flow in enumerate(prepared.plan.flows):
            rtpus = {task.name: self._subsystems.unit(task.rtpu) for task in flow.tasks}
            constants = prepared.constants[number]
            table = self._subsystems.table(flow.subsystem)
            running[number] = RunningSubsystem(flow.subsystem, table, prepared.flows[number], rtpus, constants)
        return running
