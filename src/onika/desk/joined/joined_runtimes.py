"""Several runtimes that carry out one application, spoken to as if they were one.

A plan is taken apart among them; what happens is told with the numbers that flows have in the whole; the run is over
when all parts are, and is completed when all are.
"""

from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack
from itertools import chain
from time import monotonic
from types import TracebackType
from typing import TYPE_CHECKING, Any

from msgspec import structs

from onika.desk.joined import meeting_links
from onika.desk.joined.joint_recording import JointRecording
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.plan_parts import PlanPart, parts_of
from onika.desk.run.run import Opens
from onika.desk.run.runtime_conversation import PATIENCE_S, NumberedResponse
from onika.desk.run.settings import RunSettings
from onika.link.starting.runtime_address import address_of
from onika.wire import event, live, request, steer
from onika.wire.plan import Plan
from onika.wire.rendezvous_link import MeetingTerms
from onika.wire.world_values import WorldValues
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason_with_place

if TYPE_CHECKING:
    from onika.desk.run.remote_runtime import RemoteRuntime

_LISTS = ("tasks", "skews_us", "switches_us", "steps", "remarks")
_TO_ALL = (request.Stop, request.Abort, live.Reset)


class JoinedRuntimes:
    """`runtimes` are entered with it; `sites` says which of them carries out which flow, `titles` what they are called.

    hosts   where each is, as the environment reaches it
    """

    def __init__(
        self,
        runtimes: "Sequence[RemoteRuntime]",
        sites: Mapping[str, int],
        titles: Sequence[str],
        hosts: Sequence[str],
    ) -> None:
        self._runtimes = runtimes
        self._sites = sites
        self._titles = titles
        self._hosts = hosts
        self._parts: list[PlanPart] = []
        self._terms: MeetingTerms | None = None
        self._results: dict[int, event.Result] = {}
        self._early: deque[tuple[int, event.Event]] = deque()
        self._ending = ExitStack()
        self._asked: request.Prepare | None = None
        self._recording: JointRecording | None = None

    def __enter__(self) -> "JoinedRuntimes":
        with ExitStack() as entering:
            for runtime in self._runtimes:
                entering.enter_context(runtime)
            self._ending = entering.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._recording is not None:
            self._recording.close()
        self._ending.__exit__(kind, fault, trace)

    @property
    def pid(self) -> int | None:
        """None: none of them was launched from here."""
        return None

    def printed(self) -> str:
        """What their processes print is not known here."""
        return ""

    def black_box(self) -> str:
        """None is known here."""
        return ""

    # Requests

    def ask(self, message: request.Request) -> request.Response:
        """Ask those whom it concerns; raises LinkLost where one of them is gone, or TimeoutError."""
        match message:
            case request.Prepare():
                return self._prepare(message)
            case request.Begin():
                return self._begin(message)
            case steer.Who():
                return self._who()
            case request.Snapshot():
                return self._snapshot()
        if isinstance(message, _TO_ALL):
            return self._first_refusal(self._ask_all([message] * len(self._runtimes)))
        subsystem = getattr(message, "subsystem", "")
        return self._runtimes[self._site_of(subsystem)].ask(message)

    def _prepare(self, message: request.Prepare) -> request.Response:
        self._asked = message
        self._parts = parts_of(message.plan, self._sites)
        asked = [request.Prepare(part.plan, part.targets(message.targets)) for part in self._parts]
        answers = self._ask_all(asked)
        prepared = [answer for answer in answers if isinstance(answer, request.Prepared)]
        if len(prepared) < len(answers):
            return self._first_refusal(answers)
        faults = tuple(fault for answer in prepared for fault in answer.faults)
        notes = tuple(reason for answer in prepared for reason in answer.notes)
        if not faults:
            terms = meeting_links.link(self._parts, self._titles, self._hosts, self._ask_all)
            if isinstance(terms, Reason):
                faults = (request.FaultText("--at", 0, terms, Reason.of("words.nothing_run")),)
            else:
                self._terms = terms
                notes = (*notes, meeting_links.note(terms, self._titles))
        resolved = tuple(
            structs.replace(each, flow=part.flows[each.flow])
            for part, answer in zip(self._parts, prepared, strict=True)
            for each in answer.resolved
        )
        worlds = {world: is_simulated for answer in prepared for world, is_simulated in answer.worlds.items()}
        return request.Prepared(faults, notes, resolved, worlds)

    def _begin(self, message: request.Begin) -> request.Response:
        """Begin on all; where one will not, the others are aborted. None begins where no recording can be made."""
        if message.record and self._asked is not None:
            try:
                self._recording = JointRecording(self._asked, message, self._stations())
            except OSError as wrong:
                return request.Refused(Reason.of("host.no_recording", why=system_reason_with_place(wrong)))
            self._ask_all([_heard(part) for part in self._parts])
        asked = [
            structs.replace(message, record="", meets=self._terms, watch=_watched(part, message.watch))
            for part in self._parts
        ]
        refusal = self._first_refusal(self._ask_all(asked))
        if isinstance(refusal, request.Refused):
            self._ask_all([request.Abort(refusal.reason)] * len(self._runtimes))
        return refusal

    def _stations(self) -> dict[str, str]:
        """What the runtime of each flow is called."""
        parts = zip(self._titles, self._parts, strict=True)
        return {flow.subsystem: title for title, part in parts for flow in part.plan.flows}

    def _who(self) -> request.Response:
        answers = self._ask_all([steer.Who()] * len(self._runtimes))
        positions = [answer.flows for answer in answers if isinstance(answer, steer.Positions)]
        return steer.Positions(tuple(position for flows in positions for position in flows))

    def _snapshot(self) -> request.Response:
        answers = self._ask_all([request.Snapshot()] * len(self._runtimes))
        worlds = [answer for answer in answers if isinstance(answer, request.Worlds)]
        return request.Worlds({name: taken for answer in worlds for name, taken in answer.snapshots.items()})

    def _ask_all(self, asked: Sequence[request.Request]) -> list[request.Response]:
        """Ask each its own request; all carry it out at one time."""
        numbers = [runtime.send(message) for runtime, message in zip(self._runtimes, asked, strict=True)]
        answers: dict[int, request.Response] = {}
        until = monotonic() + PATIENCE_S
        while len(answers) < len(numbers):
            if monotonic() > until:
                raise TimeoutError(Reason.of("desk.no_answer_of_all"))
            for site, runtime in enumerate(self._runtimes):
                for message in runtime.messages(0.0 if site in answers else 0.02):
                    if not isinstance(message, NumberedResponse):
                        self._early.append((site, message))
                    elif message.number == numbers[site]:
                        answers[site] = message.response
        return [answers[site] for site in range(len(numbers))]

    def _first_refusal(self, answers: Sequence[request.Response]) -> request.Response:
        refused = (answer for answer in answers if isinstance(answer, request.Refused))
        return next(refused, answers[0])

    def _site_of(self, subsystem: str) -> int:
        for site, part in enumerate(self._parts):
            if any(flow.subsystem == subsystem for flow in part.plan.flows):
                return site
        return 0

    # Events

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """What has happened since the last call; the result of the whole comes last."""
        share_s = 0.0 if self._early else timeout_s / len(self._runtimes)
        for site, runtime in enumerate(self._runtimes):
            self._early.extend((site, message) for message in runtime.events(share_s))
            if self._recording is not None:
                self._recording.read(runtime.readings())
        while self._early:
            site, message = self._early.popleft()
            if not isinstance(message, event.Result):
                yield self._recorded(self._of_whole(site, message))
                continue
            self._results[site] = message
            self._end_others(message)
            if len(self._results) == len(self._runtimes):
                yield self._recorded(self._whole())

    def _recorded(self, message: event.Event) -> event.Event:
        if self._recording is None:
            return message
        self._recording.hear(message)
        if isinstance(message, event.Result) and self._recording.reason:
            remark = Reason.of("host.recording_not_whole", why=self._recording.reason)
            return structs.replace(message, remarks=(*message.remarks, remark))
        return message

    def _end_others(self, result: event.Result) -> None:
        """Where one part was aborted the others wait for nobody."""
        if not result.completed:
            for site, runtime in enumerate(self._runtimes):
                if site not in self._results:
                    runtime.send(request.Abort(result.cause))

    def _of_whole(self, site: int, message: event.Event) -> event.Event:
        """With the numbers and the name that belong to the whole run."""
        changed: dict[str, Any] = {}
        if isinstance(message, event.Began | event.Done):
            changed["flow"] = self._parts[site].flows[message.flow]
        if getattr(message, "run", ""):
            changed["run"] = self._run
        return structs.replace(message, **changed) if changed else message

    @property
    def _run(self) -> str:
        first = min(self._parts, key=lambda part: part.flows[0])
        return first.plan.flows[0].subsystem

    def _whole(self) -> event.Result:
        results = [result for _, result in sorted(self._results.items())]
        self._results.clear()
        failed = [result for result in results if not result.completed]
        return structs.replace(
            (failed or results)[0],
            cause=failed[0].cause if failed else NOTHING,
            done=sum(result.done for result in results),
            of=sum(result.of for result in results),
            runtime_s=max(result.runtime_s for result in results),
            wall_s=max(result.wall_s for result in results),
            values=dict(chain.from_iterable(result.values.items() for result in results)),
            run=self._run,
            **{name: _of_all(results, name) for name in _LISTS},
        )


def opens(settings: RunSettings) -> Opens | None:
    """What a run's flows run on that are given to several runtimes; None: they are not."""
    if not settings.places:
        return None
    locations = list(dict.fromkeys(location for _, location in settings.places))

    from onika.desk.run.remote_runtime import connect  # within: it brings along all that speaks to other machines

    def join(_plan: Plan, _values: WorldValues) -> JoinedRuntimes:
        runtimes = [connect(location.url, location.token, location.ca) for location in locations]
        sites = {flow: locations.index(location) for flow, location in settings.places}
        urls = [location.url for location in locations]
        return JoinedRuntimes(runtimes, sites, urls, [address_of(url).host for url in urls])

    return join


def _heard(part: PlanPart) -> live.Attend:
    """What a runtime is to tell for a recording: all variables of its flows, as often as a link carries them well."""
    return live.Attend(readings=tuple(f"{flow.subsystem}/*" for flow in part.plan.flows), hz=live.RECORDED_HZ)


def _of_all(results: Sequence[event.Result], name: str) -> tuple[Any, ...]:
    """What the results of all parts have under a name, one after the other."""
    return tuple(chain.from_iterable(getattr(result, name) for result in results))


def _watched(part: PlanPart, addresses: Sequence[str]) -> tuple[str, ...]:
    """The addresses of variables that flows of this part have."""
    index = FlowIndex.of(part.plan)
    return tuple(address for address in addresses if _has(index, address))


def _has(index: FlowIndex, address: str) -> bool:
    try:
        index.home(address)
    except ValueError:
        return False
    return True
