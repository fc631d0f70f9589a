"""The runtime program: takes what sessions ask to where it is answered, and lets what runs go on."""

from time import monotonic_ns

from msgspec.structs import replace

from onika.host.driver import Driver
from onika.host.edit.editor import Editor, refused
from onika.host.inspection import Look
from onika.host.loading.loader_client import LoaderClient, NotYet
from onika.host.loading.module_description import describe
from onika.host.loading.module_questions import Loading
from onika.host.loading.plan_preparation import Preparation, inspect, prepare
from onika.host.recording.recorder import Recorder
from onika.host.run.run import Performance
from onika.host.sessions.control_authority import Holders
from onika.host.sessions.leases import Leases
from onika.host.sessions.presence import Company
from onika.host.sessions.request_backlog import Answer, Backlog
from onika.host.sessions.request_server import Call, Gate
from onika.host.subsystems.run_commands import RunCommands
from onika.host.subsystems.subsystem_registry import Stage, Tell
from onika.host.units.process_socket import Post
from onika.link.caller import Role
from onika.runtime.subsystem import RunningSubsystem
from onika.wire import event, holding, live, request, steer


class Program:
    """One runtime: subsystems held by hand and by applications, side by side."""

    def __init__(
        self, gate: Gate, driver: Driver, loading: Loading, rtpus: tuple[str, ...], lease_ns: int | None = 0
    ) -> None:
        self._gate = gate
        self._driver = driver
        self._loading = loading
        self._prepared: dict[str, Preparation] = {}
        self._backlog = Backlog()
        self.stage = Stage(driver, gate.tell, rtpus)
        driver.listen(self.stage)
        self._editor = Editor(self.stage, loading)
        self._run_commands = RunCommands(self.stage)
        self._company = Company(gate, lambda: self.holders.watching, self._lease_of)
        self.holders = Holders(self.stage, gate.tell, self._run_commands, self._company.sessions)
        self.leases = Leases(self.holders, gate.hearing, lease_ns, deaf=gate.deaf_ns)
        self._look = Look(self.stage, driver, gate, rtpus)
        self._recorder = Recorder(self.stage, driver, gate, rtpus)
        self.is_stopped = False
        self.is_over = False

    @property
    def is_running(self) -> bool:
        """Whether an application is executed now."""
        return bool(self.stage.performances)

    def readers(self) -> list[Post]:
        """What to wait for besides the gate and the driver: the loader, and who writes a recording."""
        return [*([self._loading.post] if isinstance(self._loading, LoaderClient) else []), *self._recorder.readers()]

    def wait_s(self, most_s: float) -> float:
        """How long to wait at most, where nothing else is to be done for so long."""
        now = monotonic_ns()
        due = [one for one in (self._look.due_ns(now), self.leases.due_ns()) if one is not None]
        return min([most_s, *(one * 1e-9 for one in due)])

    def serve(self) -> None:
        """Carry out what was asked; look after sessions that are gone."""
        self._try_again()
        calls = self._gate.requests()
        for session in self.leases.judge(self._driver.now):  # before anything that takes time
            self._prepared.pop(session, None)
        self.holders.expire(monotonic_ns())
        for call in calls:
            self._serve(call)
        self._company.look()
        for session in self._gate.lost():
            self._prepared.pop(session, None)
            self.stage.hold.release(session)
            self.stage.repeat.end(session)
            self._recorder.lost(session)
            self._look.forget(session)
            self.holders.lost(session, self._driver.now)

    def advance(self, wall_ns: int) -> bool:
        """Let everything go on for about so long; tell what is over. False: nothing happens by itself."""
        self._repeat()
        goes_on = self._driver.advance(wall_ns) or self.stage.is_repeat_due
        if not self.stage.repeat.is_on(self._driver.now):
            self.stage.hold.say(self._driver.now)
        self._recorder.serve()
        for performance in list(self.stage.performances):
            if performance.is_through(self._driver.is_at_rest):
                result = performance.result(self._driver.digest, self._driver.outside)
                if not self._recorder.may_end(performance, result):
                    continue
                self.stage.performances.remove(performance)
                self.stage.hold.release(performance.session)
                self.stage.repeat.end(performance.session)
                performance.end(result)
        self._look.show(monotonic_ns())
        return goes_on

    def take(self, session: str, prepared: Preparation) -> None:
        """The next plan of a session to run; one with faults leaves nothing to run."""
        self._prepared.pop(session, None)
        if not prepared.faults:
            self._prepared[session] = prepared

    def begin(self, session: str, asked: request.Begin) -> request.Response:
        """Start a run of the session's plan on empty, zeroed tables (law 4)."""
        prepared = self._prepared.get(session)
        if prepared is None:
            return request.Refused("no plan is prepared, or it has faults")
        refusal = self.holders.occupied(session, [flow.subsystem for flow in prepared.plan.flows])
        if refusal or self.is_stopped:
            return request.Refused(refusal or "the runtime is stopped; reset it first")
        gone = [one for flow in prepared.plan.flows for task in flow.tasks if (one := self.stage.gone(task.rtpu))]
        if gone:
            return request.Refused(f"{gone[0]}; start the runtime anew")
        refusal = self._recorder.begin(session, asked, prepared)
        if refusal:
            return request.Refused(refusal)
        subsystems = {}
        for number, flow in enumerate(prepared.plan.flows):
            rtpus = {task.name: self.stage.unit(task.rtpu) for task in flow.tasks}
            known = prepared.constants[number]
            table = self.stage.table(flow.subsystem)
            subsystems[number] = RunningSubsystem(flow.subsystem, table, prepared.flows[number], rtpus, known)
        if not self.stage.performances:
            self._driver.begin()
        tell: Tell
        tell, name = self._gate.tell, prepared.plan.flows[0].subsystem
        if asked.is_held and self._driver.is_virtual:
            tell = self.stage.hold.begin(session, name, self._driver.now)
        self.stage.repeat.begin(session, asked, self._driver.now)
        self.stage.perform(Performance(session, prepared, asked, subsystems, self._driver, tell, self.stage.lost_units))
        self.holders.began(session)
        return request.Done()

    def _lease_of(self, session: str) -> int:
        return self.leases.of(session)

    def _serve(self, call: Call) -> None:
        def answer(response: request.Response) -> None:
            self._gate.reply(call.ticket, response)

        self._try(call, answer)

    def _try(self, call: Call, answer: Answer) -> None:
        """Carry it out, or keep it until the loader has answered what it, or one before it, depends on.

        Whether it may be asked is judged when its turn has come: another may have become the holder meanwhile.
        """
        if self._backlog.is_before(call):
            self._backlog.keep(call, answer)
            return
        refusal = self.holders.refusal(call.session, call.asked, self.is_stopped)
        refusal = refusal or self.stage.repeat.refusal(call.session, call.asked, self._driver.now)
        try:
            if refusal:
                answer(request.Refused(refusal))
            else:
                self._carry_out(call, answer)
                self._recorder.command(call.session, call.asked)
        except NotYet:
            self._backlog.keep(call, answer)

    def _repeat(self) -> None:
        """What is due of a run that is repeated is asked in the name of who began it."""
        driver, repeat = self._driver, self.stage.repeat
        asked = repeat.take(driver.now, driver.turn, self.stage.is_asking)
        if asked is not None:
            self._carry_out(Call(0, repeat.session, Role.OWNER, asked), lambda _: None)
            self._recorder.command(repeat.session, asked)

    def _carry_out(self, call: Call, answer: Answer) -> None:
        match call.asked:
            case live.Get() | live.Set():
                self._editor.ask(call.asked, answer)
            case live.Status():
                self._look.status(answer)
            case live.Advance():
                self._advance(call.asked.seconds, answer)
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

    def _try_again(self) -> None:
        """The loader has answered: what waits for it is carried out, in order, as far as it goes."""
        has_come = self._recorder.has_come()
        if (isinstance(self._loading, LoaderClient) and self._loading.take()) or has_come:
            for call, answer in self._backlog.take():
                self._try(call, answer)

    def _respond(self, session: str, asked: request.Request) -> request.Response:
        match asked:
            case request.Prepare():
                self._loading.expect(asked.plan.code)
                prepared = prepare(asked.plan, asked.targets, self._loading)
                self.take(session, prepared)
                self._recorder.keep(session, asked)
                return replace(refused(prepared.faults, prepared.notes), resolved=tuple(prepared.resolved))
            case request.Inspect():
                return refused(*inspect(asked.tasks, asked.code, self._loading))
            case live.Describe():
                return describe(asked.code, self._loading)
            case request.Begin():
                return self.begin(session, asked)
            case request.Reply():
                return self._answer(asked)
            case request.Abort():
                return self._abort(session, asked)
            case request.Stop() | live.Reset():
                return self._stop(session, asked)
            case live.Touch():
                return self._touch(asked)
            case steer.Onward():
                return self.stage.hold.onward(session, asked)
            case request.Snapshot():
                return request.Worlds(self._driver.snapshots())
            case request.Quit():
                self.is_over = True
                return request.Done()
        return self._by_hand(session, asked)

    def _by_hand(self, session: str, asked: request.Request) -> request.Response:
        match asked:
            case live.Change():
                return self.holders.takes(session, asked.subsystem, self._editor.change(asked))
            case live.Reinit():
                return self._editor.reinit(asked)
            case live.Swap():
                return self._editor.swap(asked)
            case live.Clear():
                return self._editor.clear(asked)
            case live.Close():
                return self._editor.close(asked)
            case live.Take() | live.Release():
                return self.holders.change(session, asked)
            case holding.Hand():
                return self.holders.hand(session, asked, monotonic_ns())
            case holding.Decline():
                return self.holders.decline(session, asked)
            case holding.OnlyWatch():
                return self.holders.only_watch(session)
            case holding.Sessions():
                return self._company.answer(session)
        return self._look.answer(session, asked, self.is_stopped)

    def _touch(self, asked: live.Touch) -> request.Response:
        try:
            self._driver.touch(asked.world, asked.part, asked.value)
        except ValueError as wrong:
            return request.Refused(str(wrong))
        return request.Done()

    def _answer(self, asked: request.Reply) -> request.Response:
        performance = self.stage.performance_in(asked.subsystem)
        if performance is None:
            return self._editor.answer(asked)
        performance.runner.answer(asked.subsystem, asked.task, asked.line)
        return request.Done()

    def _abort(self, session: str, asked: request.Abort) -> request.Response:
        """End the applications of this session and those that are nobody's: whoever may run anything may end them."""
        meant = [one for one in self.stage.performances if asked.subsystem in ("", *one.names)]
        own = [one for one in meant if one.session in (session, "")]
        for performance in own:
            performance.runner.abort(asked.cause, self._driver.now)
        if meant and not own:
            other = meant[0]
            return request.Refused(f"application {other.application} was begun by {other.session}; everybody can stop")
        return request.Done()

    def _stop(self, session: str, asked: request.Stop | live.Reset) -> request.Response:
        """Straight to the devices and every unit; left by a deliberate reset only (law 27)."""
        cause = ""
        if isinstance(asked, request.Stop):
            self._driver.stop()
            cause = asked.cause
            for performance in self.stage.performances:
                performance.runner.abort(cause, self._driver.now)
            for one in self.stage.live.values():
                one.desired.turn_everything_off()
        else:
            self._driver.reset()
        self.is_stopped = isinstance(asked, request.Stop)
        self._gate.tell(event.Stopped(self.is_stopped, cause), "", session)
        return request.Done()

    def _advance(self, seconds: float, answer: Answer) -> None:
        if not self._driver.is_virtual:
            answer(request.Refused("wall time passes by itself; only virtual time can be let pass"))
        elif not 0 <= seconds <= 1e6:
            answer(request.Refused(f"expected 0 to 1000000 seconds, found {seconds:g}"))
        else:
            self.stage.when(self._driver.now + round(seconds * 1e9), lambda: answer(request.Done()))
