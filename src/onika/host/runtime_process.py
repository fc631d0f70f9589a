"""The process of a runtime: launched (`--link-fd N --parent PID`), or reachable by `--listen HOST:PORT`, or both."""

import argparse
import os
import secrets
import select
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import monotonic_ns

from onika.booking.book import BookingBook, book_path
from onika.files.state.access import STRANGERS, WRITING, Access, guard
from onika.files.state.state_directory import guarded, make_own, state_directory
from onika.files.state.staying_runtime import StayingFile, StayingRuntime
from onika.host.guards.call_watchdog import CallWatchdog
from onika.host.guards.code_guard import CodeGuard, own_code
from onika.host.guards.code_watch import CodeWatch
from onika.host.guards.descriptor_guard import DescriptorGuard
from onika.host.guards.memory_limit import bound
from onika.host.guards.outside_guard import stay_inside
from onika.host.guards.watchman import Watchman
from onika.host.loading.loader import Loader
from onika.host.loading.loader_client import LoaderClient
from onika.host.loading.loader_start import LoaderStart
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.realtime_scheduling import RUNNER_PRIORITY, fine_timers, first_in_first_out, still_garbage
from onika.host.program import RuntimeProgram
from onika.host.recording.black_box_holder import BlackBoxHolder, HolderProcess, InProcessHolder
from onika.host.renewal import Renewal
from onika.host.sessions.audit_log import AuditLog
from onika.host.sessions.booked_use import BookedUse
from onika.host.sessions.listen_options import ListenOptions, judge
from onika.host.sessions.listener_process import ListenerProcess
from onika.host.sessions.network_channel import NetworkChannel
from onika.host.sessions.request_server import RequestServer
from onika.host.sessions.site_clock import SiteClock
from onika.host.shutdown import ShutdownSignals
from onika.host.units.garbage import Garbage
from onika.host.units.virtual import VirtualDriver
from onika.host.units.wall import WallDriver
from onika.host.units.world_registry import open_world
from onika.link.address import Address
from onika.link.child.launcher import inherit
from onika.link.sessions import Sessions
from onika.record.black_box_folder import black_box_folder
from onika.ring.last_words import LastWords
from onika.ring.segment import Segment
from onika.runtime.execution.whereabouts import Whereabouts
from onika.store.audit_trail import OFF, AuditTrail, open_for
from onika.wire import event
from onika.wire.world_values import options_of, world_values
from onika.words.own_language import own_language
from onika.words.reason import Reason, in_language, reason_of
from onika.words.system_error import system_reason

_SLICE_NS = 20_000_000
_REST_NS = 300_000_000


def run(given: argparse.Namespace, loader_start: LoaderStart) -> None:
    """The process, by its command line, with its loader that is coming up."""
    ending = ShutdownSignals(is_launched=given.parent is not None)
    loader = Loader(loader_start, stays_inside=given.forecast)
    try:
        _run(given, loader, ending)
    finally:
        loader.close()


def _run(given: argparse.Namespace, loader: Loader, ending: ShutdownSignals) -> None:
    _guard_files(given)
    staying = _staying(given)
    listener = _listener(given)
    if staying is not None and listener is not None:
        staying.say(StayingRuntime(Address.parse(listener.address).port, os.getpid()))
    audit = _audit(given)
    loader_client = LoaderClient(loader, given.world)
    server = _server(given, listener, audit)
    booked = _booked(given, server)
    try:
        if given.virtual:
            _virtual(given, server, loader_client, listener, ending, booked)
        else:
            holder = None if given.no_black_box else HolderProcess()  # it comes up beside the others
            wall = _wall_driver(_rtpus(given), server, with_fifo=not given.no_fifo)
            fine_timers()
            if not given.no_fifo:
                first_in_first_out(RUNNER_PRIORITY)
            try:
                lease_ns = None if given.lease is None else round(given.lease * 1e9)
                program = RuntimeProgram(server, wall, loader_client, _rtpus(given), lease_ns, booked=booked)
                if listener is not None:
                    program.network.adopt(listener)
                _keep_last_seconds(program, holder, HolderProcess)
                _wall(program, server, wall, ending)
            finally:
                wall.close()
    finally:
        if audit is not None:
            audit.note("the runtime ends")
            audit.close()
        if listener is not None:
            listener.close()
        if staying is not None:
            staying.close()


def _watched_calls(given: argparse.Namespace) -> tuple[Whereabouts, CodeWatch]:
    """Who is told whose code runs, and interrupts what does not return; and who lets nobody replace code of ours."""
    watchdog = CallWatchdog()
    last_words = None if given.last_words is None else LastWords(Segment.attach(given.last_words).view)
    leave = _print if last_words is None else last_words.leave
    code_watch = CodeWatch(CodeGuard(own_code()), leave)
    Watchman(code_watch, watchdog, leave).begin()
    if last_words is not None and given.link_fd is not None:
        watchdog.watch.memory = last_words.name
        watchdog.watch.also = DescriptorGuard(given.link_fd, last_words.watch, leave).watch
    return watchdog.watch, code_watch


def _audit(given: argparse.Namespace) -> AuditTrail | None:
    """The audit trail: where it was asked for, else in wall time, which moves something, at its usual place."""
    if given.audit == OFF or (given.virtual and not given.audit):
        return None
    try:
        return open_for(given.audit)
    except OSError as wrong:
        _print(Reason.of("host.no_audit_trail", why=reason_of(wrong)))
        if given.audit:
            raise SystemExit(2) from None
    return None


def _watch(server: RequestServer, audit: AuditTrail) -> None:
    def complain(why: Reason) -> None:
        server.tell(event.Lost("audit trail", Reason.of("host.audit_unwritable", why=why), 0.0))

    audit.note("the runtime begins", True, about=f"process {os.getpid()}")
    server.watcher = AuditLog(audit, complain)


def _server(given: argparse.Namespace, listener: ListenerProcess | None, audit: AuditTrail | None) -> RequestServer:
    server = RequestServer(Sessions(secrets.token_hex(16)), monotonic_ns, accepts_code=given.accept_code)
    if listener is not None:
        server.welcome(listener)
    server.libraries = tuple(given.library)
    if audit is not None:
        _watch(server, audit)
    if given.link_fd is not None:
        server.adopt(inherit(given.link_fd))
    return server


def _booked(given: argparse.Namespace, server: RequestServer) -> BookedUse | None:
    """The bookings of the robot, where it has a name; the end where its book cannot be used."""
    if not given.robot:
        return None
    path = Path(given.book) if given.book else book_path(os.environ)
    try:
        make_own(path.parent)
        book = BookingBook(path)
    except OSError as wrong:
        _print(reason_of(wrong))
        raise SystemExit(2) from None
    return BookedUse(given.robot, book, SiteClock(), server.tell, is_needed=given.require_booking)


def _keep_last_seconds(
    program: RuntimeProgram, holder: BlackBoxHolder | None, make_holder: Callable[[], BlackBoxHolder]
) -> None:
    if holder is not None:
        program.recordings.keep_last_seconds(black_box_folder(os.environ), holder, make_holder)


def _listener(given: argparse.Namespace) -> ListenerProcess | None:
    """Listen, if that was asked for; end with everything that is missing for it."""
    if not given.listen:
        return None
    wanted = ListenOptions(given.listen, given.cert, given.key, given.users, tuple(given.name))
    listening, faults, token_at = judge(wanted)
    if listening is None:
        for fault in faults:
            _print(fault.sentence)
        raise SystemExit(2)
    listener = ListenerProcess(listening)
    try:
        listener.open()
    except OSError as wrong:
        listener.close()
        _print(reason_of(wrong))
        raise SystemExit(2) from None
    # one line and one write, so that whoever waits for it reads it whole
    token = f", token in {token_at}" if token_at else ""
    sys.stdout.write(f"onika runtime: listening on {listener.address}{token}\n")
    sys.stdout.flush()
    return listener


def _staying(given: argparse.Namespace) -> StayingFile | None:
    """Where it says that it stays; the end where another one does."""
    if not given.stay:
        return None
    try:
        return StayingFile(Path(given.stay))
    except OSError as wrong:
        _print(Reason.of("host.not_to_stay", path=given.stay, why=system_reason(wrong)))
        raise SystemExit(2) from None


def _guard_files(given: argparse.Namespace) -> None:
    """Nobody else can use what is kept, and what says who is let in; the end, with the reasons, where that fails."""
    named = ((given.users, WRITING), (given.cert, WRITING), (given.key, STRANGERS))
    audit = "" if given.audit == OFF else given.audit
    files = [Access(Path(path), denied) for path, denied in (*named, (audit, WRITING)) if path]
    report = guard((*guarded(state_directory(os.environ)), *files))
    for sentence in report.sentences:
        _print(sentence)
    if report.refused:
        raise SystemExit(2)


def _virtual(
    given: argparse.Namespace,
    server: RequestServer,
    loader: LoaderClient,
    listener: ListenerProcess | None,
    ending: ShutdownSignals,
    booked: BookedUse | None,
) -> None:
    """Program after program in virtual time, each beginning anew where the one before was renewed."""
    watch, code_watch = _made_ready(given)
    garbage, network, renewal = Garbage(), NetworkChannel(server), None
    if listener is not None:
        network.adopt(listener)
    with code_watch.blaming():
        while True:
            driver = _virtual_driver(given, server, watch, renewal)
            program = RuntimeProgram(server, driver, loader, _rtpus(given), network=network, booked=booked)
            _keep_last_seconds(program, None if given.no_black_box else InProcessHolder(), InProcessHolder)
            if renewal is not None:
                program.go_on(renewal)
            _turns(program, server, driver, ending, garbage)
            renewal = program.renewal
            if renewal is None:
                break
            program.leave()
            driver.close()
    _say_last(server)
    program.close()


def _made_ready(given: argparse.Namespace) -> tuple[Whereabouts, CodeWatch]:
    """This process is made ready for virtual time; whoever is told whose code runs, and whoever looks at ours."""
    preload()
    watches = _watched_calls(given)
    bound()
    still_garbage()
    if given.forecast:
        stay_inside()
    return watches


def _virtual_driver(
    given: argparse.Namespace, server: RequestServer, watch: Callable[[str], None], renewal: Renewal | None
) -> VirtualDriver:
    """What moves in virtual time, from its beginning."""
    shake = given.shake if renewal is None else renewal.asked.shake
    values = world_values(given.world_value) if renewal is None else renewal.asked.world_values
    worlds = partial(open_world, shake=shake, values=values)
    driver = VirtualDriver(_rtpus(given), server.tell, worlds, watch, given.scale, watches_mishaps=given.forecast)
    driver.options = options_of(shake, values)
    return driver


def _rtpus(given: argparse.Namespace) -> tuple[str, ...]:
    return tuple(given.rtpu) or ("rt0",)


def _wall_driver(rtpus: tuple[str, ...], server: RequestServer, *, with_fifo: bool) -> WallDriver:
    """The processes of wall time; the end, with the reason, where one of them does not come up."""
    try:
        return WallDriver(rtpus, server.tell, with_fifo=with_fifo)
    except ValueError as wrong:
        _print(reason_of(wrong))
        raise SystemExit(1) from None


def _print(reason: Reason) -> None:
    """Say it to whoever started this program, in the language of that one."""
    sys.stderr.write(f"{in_language(reason, own_language())}\n")


def _turns(
    program: RuntimeProgram, server: RequestServer, driver: VirtualDriver, ending: ShutdownSignals, garbage: Garbage
) -> None:
    """As fast as it goes while something happens by itself; else wait for the environment."""
    while server.is_open and not program.is_over and not ending.is_asked and program.renewal is None:
        goes_on = program.advance(_SLICE_NS)
        if goes_on:
            garbage.note()
        else:
            garbage.collect(None)
        wait_s = 0.0 if goes_on else server.wait_s(program.wait_s(driver.wait_s()))
        select.select([*server.readers(), *program.readers()], server.writers(), [], wait_s)
        program.serve()


def _wall(program: RuntimeProgram, server: RequestServer, driver: WallDriver, ending: ShutdownSignals) -> None:
    """Woken by the processes, by the environment, or by time."""
    while server.is_open and not program.is_over and not ending.is_asked:
        readers = [*server.readers(), *program.readers(), *(post.post for post in driver.posts())]
        select.select(readers, server.writers(), [], server.wait_s(program.wait_s(driver.wait_s())))
        driver.look_after()  # first the robot, then the listeners
        program.advance(0)
        program.serve()
    _come_to_rest(server, driver)
    _say_last(server)
    program.close()


def _come_to_rest(server: RequestServer, driver: WallDriver) -> None:
    """Every drive in hold before the processes end, as long as that takes within limits."""
    driver.stop()
    until = monotonic_ns() + _REST_NS
    while not driver.is_at_rest() and monotonic_ns() < until:
        select.select([post.post for post in driver.posts()], [], [], 0.02)
        driver.look_after()
        server.flush()


def _say_last(server: RequestServer) -> None:
    """Let the last words out, for a moment at most."""
    until = monotonic_ns() + 500_000_000
    server.close(Reason.of("link.runtime_ends"))
    while server.is_waiting and monotonic_ns() < until:
        select.select([], server.writers(), [], 0.05)
        server.requests()
