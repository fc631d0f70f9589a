"""A session carried out once more, line after line of its log, by the environment itself (requirement H08).

Acts are done again; what a runtime has told and what others have written comes from the log. Nothing goes to a runtime,
no command of a button is run, and nothing is fetched: what would come of that the log has, or it is told as not there.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import msgspec

from onika.desk.environment import initial_model
from onika.desk.environment.diary_record import event_of, reply_of
from onika.desk.environment.environment import ActAnswer, Environment, Handler
from onika.desk.environment.file import recovery, recovery_record
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.desk.environment.reconcile import runtime_loss
from onika.desk.environment.refresh import refreshed
from onika.desk.environment.replay.recorded_runtime import RecordedRuntime
from onika.desk.environment.replay.replay_place import ReplayPlace
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.settings import Settings
from onika.files.state import session_log
from onika.files.state.session_log import LogLine
from onika.wire import act
from onika.words.fault import Fault, Place
from onika.words.reason import Reason, reason_of


class SessionPlayer:
    """Replays the lines of one session at a place.

    handlers    what each act does
    file        what the log is called, for faults
    """

    def __init__(
        self, lines: Sequence[LogLine], place: ReplayPlace, handlers: Mapping[type, Handler], file: str
    ) -> None:
        self.lines = lines
        self.place = place
        self.position = 0
        """How many lines were carried out."""
        self.faults: list[Fault] = list(place.faults)
        self._file = file
        self._runtime = RecordedRuntime()
        self._waiting: dict[int, LogLine] = {}
        """Acts that are not answered yet, by their places."""
        facts = dict(place.here(next((line.record for line in session_log.beginning(lines)), {}))).get("start")
        self._begin(facts if isinstance(facts, dict) else {}, handlers)

    def _begin(self, facts: Mapping[str, Any], handlers: Mapping[type, Handler]) -> None:
        model, says = initial_model.opened(self.place.site, self.place.state, {})
        model = replace(model, settings=_settings(facts.get("settings"), model.settings))
        worker = AtOnce(self._become)
        services = Services(
            self.place.site, self._now, self.place.state, calendar=self._now,
            reading=worker, comparing=worker, keeping=worker, meshing=worker,
        )  # fmt: skip
        self.environment = Environment(model, handlers, services, self._runtime)
        self.says = says
        unsaved = facts.get("unsaved")
        records = unsaved if isinstance(unsaved, list) else []
        self.environment.become(lambda model: _had_back(model, records, self.place))

    @property
    def is_over(self) -> bool:
        """Whether the last line was carried out."""
        return self.position >= len(self.lines)

    @property
    def wait_s(self) -> float:
        """Seconds that passed in the session between the line carried out last and the next one."""
        if self.is_over or self.position == 0:
            return 0.0
        return max(0.0, self.lines[self.position].at_s - self.lines[self.position - 1].at_s)

    def step(self) -> LogLine | None:
        """Carry out the next line; None where there is none."""
        if self.is_over:
            return None
        line = self.lines[self.position]
        self.position += 1
        self._carry_out(line, self.place.here(line.record))
        if self.position == len(self.lines):
            for unanswered in self._waiting.values():
                self._fault(unanswered, Reason.of("replay.not_answered"), "replay.act_stays")
        return line

    def _carry_out(self, line: LogLine, record: Mapping[str, Any]) -> None:
        kind = next((name for name in self._KINDS if name in record), None)
        try:
            if kind is not None:
                self._KINDS[kind](self, line, record)
        except msgspec.ValidationError as wrong:
            reason = Reason.of("replay.unknown_words", kind=str(kind), why=Reason.plain(str(wrong)))
            self._fault(line, reason, "replay.not_carried_out")

    def _act(self, line: LogLine, record: Mapping[str, Any]) -> None:
        command: act.AnyAct = msgspec.convert(record["act"], act.AnyAct, str_keys=True)
        if strange := self.place.strange_path(record["act"]):
            self._fault(line, Reason.of("replay.elsewhere", path=strange), "replay.not_carried_out")
            return
        self._waiting[line.place] = line
        self.environment.do(command, f"person {record.get('by', 0)}", partial(self._answered, line, record))

    def _answered(self, line: LogLine, record: Mapping[str, Any], answer: ActAnswer) -> None:
        self._waiting.pop(line.place, None)
        before = record.get("no", "")
        now = "" if answer.no is None else answer.no.reason.key
        if before != now and (before == "" or now == ""):
            texts = ("" if answer.no is None else answer.no.reason.text, str(before))
            key = "replay.refused_now" if now else "replay.refused_then"
            self._fault(line, Reason.of(key, event=line.event, why=texts[now == ""]), "replay.as_it_comes")
        elif not now and "value" in record and record["value"] != answer.value:
            given = Reason.of("replay.other_value", value=str(record["value"]), given=str(answer.value))
            self._fault(line, given, "replay.as_it_comes")

    def _reply(self, line: LogLine, record: Mapping[str, Any]) -> None:
        order = self._runtime.awaiting(str(record.get("station", "")), str(record.get("to", "")))
        if order is None:
            self._fault(
                line, Reason.of("replay.not_asked", request=str(record.get("to", ""))), "replay.not_carried_out"
            )
        else:
            self.environment.replied(order, reply_of(record["reply"]))

    def _event(self, _line: LogLine, record: Mapping[str, Any]) -> None:
        self.environment.receive(event_of(record["event"]), str(record.get("station", "")))

    def _lost(self, _line: LogLine, record: Mapping[str, Any]) -> None:
        reason = msgspec.convert(record["lost"], Reason)
        self.environment.become(lambda model: runtime_loss.lost(model, reason), str(record.get("station", "")))

    def _changed_file(self, line: LogLine, record: Mapping[str, Any]) -> None:
        path = Path(str(record["file"]))
        text = record.get("text")
        if not self.place.holds(path):
            self._fault(line, Reason.of("replay.elsewhere", path=str(path)), "replay.not_carried_out")
            return
        try:
            if isinstance(text, str):
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8", errors="replace", newline="")
            elif record.get("is_there"):
                self._fault(line, Reason.of("replay.text_lacks", path=path.name), "replay.with_what_is_there")
            else:
                path.unlink(missing_ok=True)
        except OSError as wrong:
            self._fault(line, reason_of(wrong), "replay.not_carried_out")
        self.environment.become(partial(refreshed, changed={path}, site=self.place.site))

    def _left_out(self, line: LogLine, record: Mapping[str, Any]) -> None:
        reason = Reason.of("replay.too_long", kind=str(record["left_out"]), count=str(record.get("bytes", "")))
        self._fault(line, reason, "replay.not_carried_out")

    _KINDS: Mapping[str, Callable[["SessionPlayer", LogLine, Mapping[str, Any]], None]] = {
        "act": _act,
        "reply": _reply,
        "event": _event,
        "lost": _lost,
        "file": _changed_file,
        "left_out": _left_out,
    }
    """What is done with a line, by what its record has; another line only says what the page did."""

    def _become(self, change: Callable[[Model], Done]) -> None:
        self.environment.become(change)

    def _fault(self, line: LogLine, reason: Reason, instead: str) -> None:
        self.faults.append(Fault(Place(self._file, line.number), reason, Reason.of(instead)))

    def _now(self) -> float:
        """The time of the session."""
        line = self.lines[max(0, min(self.position, len(self.lines)) - 1)] if self.lines else None
        return 0.0 if line is None else line.at_s


class AtOnce(BackgroundWorker):
    """Work that is done at once, so that what follows finds it done."""

    def do(self, work: Callable[[], None]) -> None:
        """Do it."""
        work()


def _had_back(model: Model, unsaved: Sequence[Any], place: ReplayPlace) -> Done:
    """With the documents that were not saved when the session began."""
    records: list[recovery_record.RecoveryRecord] = []
    for text in unsaved:
        try:
            records += recovery_record.read(str(text)).every
        except ValueError:
            continue  # an edited log; what it lacks shows in the acts that need it
    ours = [record for record in records if all(place.holds(Path(path)) for path in (record.path, record.base) if path)]
    return recovery.reopened(model, ours)


def _settings(value: Any, usual: Settings) -> Settings:
    """The settings of the session, of which no diary is kept again."""
    try:
        return replace(msgspec.convert(value, Settings), keeps_diary=False)
    except msgspec.ValidationError:
        return usual
