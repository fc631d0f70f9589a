"""The runtime program: takes what sessions ask to where it is answered, and lets what runs go on."""

from collections.abc import Iterable
from time import monotonic_ns

from msgspec.structs import replace

from onika.host.application_runs import ApplicationRuns
from onika.host.clock_requests import ClockRequests
from onika.host.driver import Driver
from onika.host.edit.editor import LiveEditor, refused
from onika.host.foresight.questions import Questions
from onika.host.foresight.situation import SessionFacts
from onika.host.hand_requests import HandRequests
from onika.host.inspection import Inspection
from onika.host.loading.loader_client import LoaderClient, NotYet
from onika.host.loading.module_description import describe
from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_preparation import inspect, prepare
from onika.host.loading.pose_solution import solve
from onika.host.loading.world_kinds import world_list
from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.runtime_recordings import RuntimeRecordings
from onika.host.recording.sampling import Sampling
from onika.host.renewal import Renewal
from onika.host.run.rendezvous_links import RendezvousLinks
from onika.host.sessions.booked_use import BookedUse
from onika.host.sessions.control_authority import ControlAuthority
from onika.host.sessions.leases import Leases
from onika.host.sessions.network_channel import NetworkChannel
from onika.host.sessions.presence import Presence
from onika.host.sessions.request_backlog import Answer, Backlog
from onika.host.sessions.request_server import RequestServer, SessionRequest
from onika.host.subsystems.motion import Motion
from onika.host.subsystems.run_commands import RunCommands
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.subsystems.unit_starts import UnitStarts
from onika.host.units.world_files import WorldFiles
from onika.host.units.world_registry import offered_worlds
from onika.link.caller import Role
from onika.link.datagrams.rendezvous_channel import RendezvousChannel
from onika.ring.segment import SharedMemoryRefused
from onika.wire import booking, holding, live, request, steer
from onika.wire.foresight import WhatIf
from onika.wire.rendezvous_link import LinkRuntimes, OfferPact
from onika.wire.samples import Sample
from onika.wire.world_source import WorldSource
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason, reason_of


class RuntimeProgram:
    """One runtime: subsystems held by hand and by applications, side by side."""

    def __init__(
        self,
        server: RequestServer,
        driver: Driver,
        loading: ModuleQuestions,
        rtpus: tuple[str, ...],
        lease_ns: int | None = 0,
        network: NetworkChannel | None = None,
        booked: BookedUse | None = None,
    ) -> None:
        self._server = server
        self._driver = driver
        self._loading = loading
        self._backlog = Backlog()
        self.subsystems = Subsystems(driver, server.tell, rtpus)
        driver.listen(self.subsystems)
        self._editor = LiveEditor(self.subsystems, loading)
        self._run_commands = RunCommands(self.subsystems)
        self._presence = Presence(server, lambda: self.authority.watching, self._lease_of)
        self.authority = ControlAuthority(self.subsystems, server.tell, self._run_commands, self._presence.sessions)
        self.leases = Leases(self.authority, server.hearing, lease_ns, deaf=server.deaf_ns)
        self.network = network or NetworkChannel(server)
        self._booked = booked
        self._look = Inspection(self.subsystems, driver, server)
        self._sampling = Sampling(self.subsystems, driver)
        self._world_files = WorldFiles()
        self.recordings = RuntimeRecordings(self.subsystems, driver, server)
        self._unit_starts = UnitStarts(self.subsystems, driver)
        self.motion = Motion(self.subsystems, driver, server.tell)
        self._hands = HandRequests(
            self.subsystems,
            driver,
            self._editor,
            self.authority,
            self.motion,
            self._presence,
            self._offered,
            server.tell,
        )
        self._links = RendezvousLinks()
        self.applications = ApplicationRuns(
            self.subsystems, driver, self.authority, self.motion, self.recordings, self._links, server.tell
        )
        recorder = self.recordings.recorder
        self._questions = Questions(self.subsystems, driver, self._session_facts, lambda: recorder.application)
        self.is_over = False
        self._clock_requests = ClockRequests(self.subsystems, driver, server, self._backlog)

    @property
    def renewal(self) -> Renewal | None:
        """In virtual time: what a new program is to begin with, in place of this one."""
        return self._clock_requests.renewal

    @property
    def is_running(self) -> bool:
        """Whether an application is executed now."""
        return bool(self.subsystems.runs)

    def readers(self) -> list[ProcessSocket | RendezvousChannel]:
        """What to wait for besides the request server and the driver: the loader, and who writes recordings."""
        loader = [self._loading.post] if isinstance(self._loading, LoaderClient) else []
        return [*loader, *self.recordings.readers(), *self.network.readers(), *self._links.readers()]

    def close(self) -> None:
        """The runtime ends: what is still to be written of its runs is written."""
        self.network.finish()
        self.recordings.finish()

    def leave(self) -> None:
        """Another program goes on, on the same links: nothing is told to this one any more."""
        self.recordings.leave()
        self.subsystems.close()

    def go_on(self, renewal: Renewal) -> None:
        """Answer who asked for this program, and carry out what was asked since."""
        self._server.reply(renewal.call.ticket, request.Done())
        for call in renewal.later:
            self._serve(call)

    def wait_s(self, most_s: float) -> float:
        """How long to wait at most, where nothing else is to be done for so long."""
        now = monotonic_ns()
        kept = self.recordings.due_ns()
        looks = (self._look.due_ns(now), self._sampling.due_ns(now), self._links.due_ns(self._driver.now))
        slots = None if self._booked is None else self._booked.due_ns()
        dues = (*looks, self.leases.due_ns(), self.network.due_ns(), slots, kept)
        return min([most_s, *(due * 1e-9 for due in dues if due is not None)])

    def serve(self) -> None:
        """Carry out what was asked; look after sessions that are gone."""
        self._try_again()
        self.network.serve()
        calls = self._server.requests()
        for session in self.leases.judge(self._driver.now):  # before anything that takes time
            self.applications.forget(session)
        self.authority.expire(monotonic_ns())
        if self._booked is not None:
            self._booked.judge(self._presence.sessions(), self.authority, self._driver.now)
        for number, call in enumerate(calls, 1):
            self._serve(call)
            if self.renewal is not None:
                self.renewal.later = calls[number:]
                return
        self._presence.look()
        for session in self._server.lost():
            self.applications.lost(session)
            self.recordings.lost(session)
            self._look.forget(session)
            self.authority.lost(session, self._driver.now)

    def advance(self, wall_ns: int) -> bool:
        """Let everything go on for about so long; tell what is over. False: nothing happens by itself."""
        self._repeat()
        self._meet_others()
        goes_on = self._driver.advance(wall_ns) or self.subsystems.is_repeat_due
        if not self.subsystems.repeat.is_on(self._driver.now):
            self.subsystems.hold.say(self._driver.now)
        self.recordings.serve()
        for run in list(self.subsystems.runs):
            if run.is_through(self._driver.is_at_rest):
                self.applications.end(run)
        self._look.show(monotonic_ns())
        self._sampling.serve()
        for outdated in self._world_files.look(self._driver.worlds, monotonic_ns(), self._driver.now * 1e-9):
            self._server.tell(outdated)
        return goes_on

    def _lease_of(self, session: str) -> int:
        return self.leases.of(session)

    def _session_facts(self) -> dict[str, SessionFacts]:
        """Who is there, as far as faults are concerned."""
        launcher = self._server.launcher
        return {
            standing.name: SessionFacts(self.leases.of(standing.name) * 1e-6, standing.name == launcher)
            for standing in self._server.sessions()
        }

    def _serve(self, call: SessionRequest) -> None:
        def answer(response: request.Response) -> None:
            self._server.reply(call.ticket, response)

        self._try(call, answer)

    def _try(self, call: SessionRequest, answer: Answer) -> None:
        """Carry it out, or keep it until the loader has answered what it, or one before it, depends on.

        Whether it may be asked is judged when its turn has come: another may have become the holder meanwhile.
        """
        if self._backlog.is_before(call):
            self._backlog.keep(call, answer)
            return
        refusal = NOTHING if self._booked is None else self._booked.refusal(call.session, call.asked)
        refusal = refusal or self.authority.refusal(call.session, call.asked, self.motion.is_stopped)
        refusal = refusal or self.subsystems.repeat.refusal(call.session, call.asked, self._driver.now)
        try:
            if refusal:
                answer(request.Refused(refusal))
            else:
                self._carry_out(call, answer)
                if not isinstance(call.asked, OfferPact | LinkRuntimes):  # they tell keys
                    self.recordings.command(call.session, call.asked)
        except NotYet:
            self._backlog.keep(call, answer)
        except SharedMemoryRefused as refused:
            answer(request.Refused(reason_of(refused)))

    def _meet_others(self) -> None:
        """Hear other runtimes of applications; where one of them was stopped everything stops here, too."""
        self._links.serve(self._driver.now)
        if self._links.is_stopped and not self.motion.is_stopped:
            self.motion.stop("", Reason.of("host.stopped_elsewhere"))

    def _repeat(self) -> None:
        """What is due of a run that is repeated is asked in the name of who began it."""
        driver, repeat = self._driver, self.subsystems.repeat
        due = repeat.take(driver.now, driver.turn, self.subsystems.is_asking)
        if due is not None:
            self._carry_out(SessionRequest(0, repeat.session, Role.OWNER, due), lambda _: None)
            self.recordings.command(repeat.session, due)

    def _carry_out(self, call: SessionRequest, answer: Answer) -> None:
        match call.asked:
            case live.Get() | live.Set():
                self._editor.ask(call.asked, answer)
            case live.Status():
                self._look.status(answer)
            case Sample():
                answer(self._sampling.answer(call.asked))
            case holding.Listen() | holding.StopListening() | OfferPact() | LinkRuntimes():
                self._of_network(call, answer)
            case booking.Book() | booking.ExtendBooking() | booking.CancelBooking() | booking.Bookings():
                answer(self._of_bookings(call, call.asked))
            case live.AddUnit():
                self._unit_starts.add(call.asked, answer)
            case live.Record():
                self.recordings.by_hand.ask(call.asked, answer)
            case live.Advance() | live.Renew():
                self._clock_requests.ask(call, call.asked, answer)
            case WhatIf():
                self._questions.ask(call.session, call.asked, self.applications.prepared(call.session), answer)
            case steer.Who():
                answer(self._run_commands.who(call.session))
            case (
                steer.Pause()
                | steer.Resume()
                | steer.Step()
                | steer.Skip()
                | steer.Pass()
                | steer.Leave()
                | steer.Mark()
                | steer.Recover()
            ):
                self._run_commands.carry_out(call.session, call.asked, self._driver.now, answer)
            case _:
                answer(self._respond(call.session, call.asked))

    def _of_network(self, call: SessionRequest, answer: Answer) -> None:
        match call.asked:
            case holding.Listen():
                self.network.open(call.asked, answer)
            case holding.StopListening():
                self.network.close(answer)
            case OfferPact() | LinkRuntimes():
                self._links.ask(call.session, call.asked, self._driver, answer)

    def _of_bookings(self, call: SessionRequest, message: booking.BookingRequest) -> request.Response:
        if self._booked is None:
            return request.Refused(Reason.of("booking.nothing"))
        return self._booked.answer(call.session, call.role, message)

    def _try_again(self) -> None:
        """The loader has answered: what waits for it is carried out, in order, as far as it goes."""
        has_come = self.recordings.recorder.has_come()
        if (isinstance(self._loading, LoaderClient) and self._loading.take()) or has_come:
            for call, answer in self._backlog.take():
                self._try(call, answer)

    def _respond(self, session: str, message: request.Request) -> request.Response:
        match message:
            case request.Prepare():
                prepared = prepare(message.plan, message.targets, self._loading)
                prepared.faults += self._offered(message.plan.worlds)
                self.applications.take(session, prepared)
                self.recordings.descriptions.keep(session, message)
                resolved, worlds = tuple(prepared.resolved), prepared.worlds
                self._driver.expect(worlds)
                return replace(refused(prepared.faults, prepared.notes), resolved=resolved, worlds=worlds)
            case request.Inspect():
                return refused(*inspect(message.tasks, message.code, self._loading, message.worlds))
            case live.Describe() | live.ListWorlds() | live.Solve():
                return self._described(message)
            case request.Begin():
                return self.applications.begin(session, message)
            case request.Reply():
                return self._answer(message)
            case request.Abort():
                return self._abort(session, message)
            case request.Stop():
                self._links.stop()
                self.motion.stop(session, message.cause)
                return request.Done()
            case steer.Onward():
                return self.subsystems.hold.onward(session, message)
            case request.Snapshot():
                return request.Worlds(self._driver.snapshots(), self._driver.standings(), self._driver.watched())
            case request.Quit():
                self.is_over = True
                return request.Done()
        answer = self._hands.answer(session, message)
        return self._look.answer(session, message, self.motion.is_stopped) if answer is None else answer

    def _offered(self, worlds: Iterable[WorldSource]) -> list[Fault]:
        """Keep the files of worlds; one that is open and was made of others is told: it stays as it is."""
        opened = self._driver.opened
        others = [files for files in worlds if opened.get(files.world, files.digest) not in ("", files.digest)]
        self._driver.offer(files for files in worlds if files not in others)
        reasons = (Reason.of("host.world_of_other_files", world=files.world) for files in others)
        return [Fault(Place(files.world), reason, NOT_RUN) for files, reason in zip(others, reasons, strict=True)]

    def _described(self, message: live.Describe | live.ListWorlds | live.Solve) -> request.Response:
        """What the code of modules or worlds says of itself."""
        if isinstance(message, live.Describe):
            return describe(message.code, self._loading)
        if isinstance(message, live.Solve):
            return solve(message, self._loading)
        return world_list(offered_worlds(), self._loading)

    def _answer(self, message: request.Reply) -> request.Response:
        run = self.subsystems.run_in(message.subsystem)
        if run is None:
            return self._editor.answer(message)
        run.runner.answer(message.subsystem, message.task, message.line)
        return request.Done()

    def _abort(self, session: str, message: request.Abort) -> request.Response:
        """End the applications of this session and those that are nobody's: whoever may run anything may end them."""
        meant = [run for run in self.subsystems.runs if message.subsystem in ("", *run.names)]
        own = [performance for performance in meant if performance.session in (session, "")]
        for run in own:
            run.end_at_wish(message.cause, self._driver.now)
        if meant and not own:
            other = meant[0]
            return request.Refused(Reason.of("host.begun_by", application=other.application, session=other.session))
        return request.Done()
