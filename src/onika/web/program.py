"""The environment as a program: model, runtime, files, diary and browsers in one loop."""

import asyncio
import os
import time
from collections.abc import Awaitable, Callable, Coroutine, Iterable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, Protocol

from onika.desk.environment import initial_model, preferences as preferring, refresh
from onika.desk.environment.diary import Diary
from onika.desk.environment.environment import ActAnswer, Environment
from onika.desk.environment.file.autosave import Autosave, UnsavedChange
from onika.desk.environment.file.disk_watch import DiskWatch
from onika.desk.environment.file.recovery import Recovery, reopened
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.button_commands import Commands
from onika.desk.environment.outcome.library_services import LibraryServices
from onika.desk.environment.outcome.network_services import NetworkServices
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.puzzle_ledger import PuzzleLedger
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.run_recorder import RunRecorder
from onika.desk.environment.runs import readiness
from onika.desk.environment.runs.forecaster import Forecaster
from onika.desk.environment.runs.readiness import ReadinessJudge
from onika.desk.environment.session_start import SessionStart
from onika.desk.environment.state.model import Model
from onika.desk.environment.stations import Stations
from onika.desk.environment.world_channel import WorldChannel
from onika.fabric.phone_book import PhoneBook
from onika.store.live_path import LivePath
from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.lock_file import LockFile
from onika.store.remote.object_cache import ObjectCache, cache_directory
from onika.store.remote.remote_libraries import RemoteLibraries
from onika.store.site import Site
from onika.web.app import PLAYER
from onika.web.environment_options import EnvironmentOptions
from onika.web.hub import Hub
from onika.web.repose import Repose
from onika.wire import act, page
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason_with_place

_LOOK_S = 1.0
"""Between two looks at the files."""

_FRAME_S = 1 / 60
_KEEP_S = 0.1
_JUDGE_S = 0.1
_STALE_S = 1.0
"""Between two looks at whether files that applications use have changed."""

_NAME = "Onika"


class OpenPage(Protocol):
    """The page of an environment, which can be asked for."""

    async def serve(self, beside: Iterable[Coroutine[Any, Any, object]]) -> None:
        """Until Ctrl-C, or until one of what runs beside ends."""
        ...

    def close(self) -> None:
        """Let nobody in any more."""
        ...


PageOpening = Callable[[Environment, Hub], OpenPage]
"""Opens the page of an environment; raises OSError where it cannot be opened."""


class EnvironmentProgram:
    """One environment from its beginning to its end; `state` is where diary and recovery are kept."""

    def __init__(self, site: Site, options: EnvironmentOptions, state: Path) -> None:
        self._path = LivePath(site.directories)
        self._site = replace(site, directories=self._path, fetcher=None)  # nobody waits for servers but its own thread
        self._options = options
        self._state = state
        self._pause: Callable[[float], Awaitable[None]] = asyncio.sleep

    async def run(self, opens: PageOpening) -> None:
        """Until Ctrl-C, with a page that `opens` opens."""
        loop = asyncio.get_running_loop()

        def post(do: Callable[[], None]) -> None:
            loop.call_soon_threadsafe(do)

        def tell(change: Callable[[Model], Done]) -> None:
            post(lambda: environment.become(change))

        commands = Commands(tell, os.environ)
        reading, comparing = BackgroundWorker(tell, "reading"), BackgroundWorker(tell, "comparing")
        keeping, meshing = BackgroundWorker(tell, "keeping"), BackgroundWorker(tell, "meshing")
        forecaster = Forecaster(self._site, BackgroundWorker(tell, "forecast")) if self._options.foresees else None
        remote = self._remote(BackgroundWorker(tell, "fetching"))
        network = NetworkServices(BackgroundWorker(tell, "network"), PhoneBook(self._state))
        surroundings = Services(
            self._site,
            time.monotonic,
            self._state,
            commands,
            reading=reading,
            comparing=comparing,
            keeping=keeping,
            meshing=meshing,
            remote=remote,
            player=PLAYER,
            network=network,
            recorder=(recorder := RunRecorder()),
        )
        launching = RuntimeLauncher(
            self._options.rtpus,
            is_virtual=self._options.is_virtual,
            with_fifo=self._options.with_fifo,
            options=("--scale", "1") if self._options.is_virtual else (),
            has_black_box=self._options.has_black_box,
        )
        stations = Stations(launching, post, time.monotonic)
        disk = DiskWatch(self._site)  # before the files are read: what is written meanwhile is seen at the first look
        model, says = initial_model.opened(
            self._site, self._state, self._options.settings(os.environ), self._options.dictionaries
        )
        environment = Environment(model, HANDLERS, surroundings, WorldChannel(stations, self._site))
        hub = Hub(environment, stations)
        hub.remember(says)
        opened = opens(environment, hub)
        environment.followers.append(PuzzleLedger(self._state, environment.say).follow)
        repose = Repose(stations, time.monotonic)
        environment.observers.append(repose.begun)
        environment.followers.append(repose.changed)
        self._pause = repose.pause
        recorder.attend(environment)
        kept, autosave = self._recovery(environment), Autosave()
        stations.begin(environment)
        diary = self._diary(environment)
        self._open(environment)
        beside = (
            self._show(hub),
            self._look(environment, disk, diary),
            self._keep(environment, kept, autosave),
            self._judge(environment),
            self._foresee(environment, forecaster),
            *((repose.keep(lambda: environment.model),) if self._options.may_repose else ()),
        )
        try:
            await opened.serve(beside)
        finally:
            opened.close()
            if forecaster is not None:
                forecaster.close()
            stations.end()
            commands.close()
            for worker in (reading, comparing, keeping, meshing, network.worker):
                worker.close()
            if remote is not None:
                remote.close()
            if diary is not None:
                diary.close()
            self._leave(environment, surroundings, kept, autosave)

    def _remote(self, worker: BackgroundWorker) -> LibraryServices | None:
        """What acts on libraries of others need; None where the user has no base directory of his own to lock them."""
        if self._site.own is None:
            return None
        access = LibraryAccess(ObjectCache(cache_directory(os.environ)), self._state)
        return LibraryServices(worker, RemoteLibraries(LockFile(self._site.own), access), self._path)

    def _leave(
        self, environment: Environment, surroundings: Services, kept: Recovery | None, autosave: Autosave
    ) -> None:
        """What is not saved is there again the next time; preferences have a file from now on (B12)."""
        if surroundings.recorder is not None:
            surroundings.recorder.close()
        if kept is not None:
            autosave.look(environment.model, 0.0)
            kept.carry_out(autosave.take_all(0.0))
            kept.leave(keeps=True)
        preferring.leave(environment.model, surroundings)

    def _diary(self, environment: Environment) -> Diary | None:
        if not self._options.has_diary:
            return None
        start = SessionStart(self._site)
        diary = Diary(self._state / "diary", lambda: environment.model, environment.say, start=start)
        environment.observers.append(diary.observe)
        environment.listening.append(diary.hear)
        environment.followers.append(diary.follow)
        return diary

    def _recovery(self, environment: Environment) -> Recovery | None:
        try:
            kept = Recovery(self._state)
            rescued = kept.recovered()
        except OSError as wrong:
            environment.say(page.Say("warning", Reason.of("desk.no_recovery", why=system_reason_with_place(wrong))))
            return None
        if rescued:
            environment.become(lambda model: reopened(model, rescued))
        return kept

    def _open(self, environment: Environment) -> None:
        """The files that were named; a blank configuration where there is nothing."""

        def report(given: ActAnswer) -> None:
            if given.no is not None:
                environment.say(page.Say("error", given.no.reason))

        for name in self._options.files:
            environment.do(act.Open(name), _NAME, report)
        if not environment.model.documents:
            environment.do(act.New(), _NAME, report)
        for station, url, token in self._options.stations:
            environment.do(act.AddStation(url, token, station, keeps=True), _NAME, report)
        if self._options.is_connected:
            first = next(iter(environment.model.documents))
            connect = act.Connect(first, self._options.url, self._options.token)
            environment.do(
                connect, _NAME, lambda given: report(given) if first in environment.model.documents else None
            )

    async def _show(self, hub: Hub) -> None:
        """The newest values, to those who watch."""
        while True:
            await self._pause(_FRAME_S if hub.is_watching else 0.1)
            hub.pump()

    async def _look(self, environment: Environment, disk: DiskWatch, diary: Diary | None) -> None:
        """Files that others change."""
        while True:
            await self._pause(_LOOK_S)
            changed = await asyncio.to_thread(disk.changed, environment.model)
            if changed:
                if diary is not None:
                    diary.look(changed)
                environment.become(partial(refresh.refreshed, changed=changed, site=self._site))

    async def _judge(self, environment: Environment) -> None:
        """Whether what is open could be run, soon after it was changed."""
        judge, stale_at = ReadinessJudge(self._site), 0.0
        while True:
            await self._pause(_JUDGE_S)
            cases = judge.cases(environment.model)
            if not cases and time.monotonic() >= stale_at and environment.model.applications:
                stale_at = time.monotonic() + _STALE_S
                cases = await asyncio.to_thread(judge.stale, environment.model)
            for case in cases:
                judgement = await asyncio.to_thread(judge.judge, case)
                environment.become(partial(readiness.judged, doc=case.opened.id, judgement=judgement))

    async def _foresee(self, environment: Environment, forecaster: Forecaster | None) -> None:
        """What applications would come to, soon after they were changed."""
        while True:
            await self._pause(_JUDGE_S)
            if forecaster is not None:
                forecaster.look(environment.model, time.monotonic())

    async def _keep(self, environment: Environment, kept: Recovery | None, autosave: Autosave) -> None:
        """What is not saved, soon after it was changed."""
        is_reported = False
        while kept is not None:
            now = time.monotonic()
            autosave.look(environment.model, now)
            changes = autosave.take(now)
            why = await _finished(kept.carry_out, changes) if changes else NOTHING
            if why and not is_reported:
                is_reported = True
                environment.say(page.Say("warning", Reason.of("desk.no_recovery", why=why)))
            await self._pause(_KEEP_S)


async def _finished(carry_out: Callable[[Sequence[UnsavedChange]], Reason], changes: Sequence[UnsavedChange]) -> Reason:
    """Done in a thread, and waited for also by whoever is cancelled meanwhile: what counts as kept is on the disk."""
    writing = asyncio.ensure_future(asyncio.to_thread(carry_out, changes))
    try:
        return await asyncio.shield(writing)
    except asyncio.CancelledError:
        await asyncio.wait((writing,))
        raise
