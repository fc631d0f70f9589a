"""The run that a recording holds, described as a whole: enough to begin the same run again (law 29)."""

import hashlib
import re
from collections.abc import Mapping
from typing import Any

import msgspec
from msgspec import Struct, structs

from onika import __version__
from onika.record.reader import Reader
from onika.record.stored import unfit
from onika.record.writer import Writer
from onika.wire.event import Result
from onika.wire.plan import Code
from onika.wire.request import Begin, Prepare
from onika.wire.world_values import WORLD_VALUE
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

HERE = "here"
"""In place of the name of the first station, which has none."""
NOTE, END, BLACK_BOX = "onika", "end", "black box"
_TOO_SHORT = Reason.of("record.cut_short")
_MOST_UNITS = 64
_OPTION = rf"(--shake [0-9]{{1,18}}|--world-value {WORLD_VALUE})"
_OPTIONS = re.compile(rf"{_OPTION}( {_OPTION}){{0,40}}", re.ASCII)
"""How a runtime is started whose worlds are shaken or varied; nothing else changes what happens in virtual time."""
_BY_HAND = "by hand"
_STATIONS = "stations"
_PLAN, _BEGIN, _CODE = "plan.json", "begin.json", "code.json"


class RunRecord(Struct, frozen=True):
    """What was run, how it was begun, and where."""

    prepare: Prepare
    begin: Begin
    rtpus: tuple[str, ...]
    is_virtual: bool
    is_fresh: bool
    """Whether it was the first thing that happened on its runtime, so that a new runtime begins as it did."""
    began: str
    """When, on the wall: ISO 8601."""
    software: str = __version__
    options: tuple[str, ...] = ()
    """What its runtime was started with beside, which changes what happens."""
    is_by_hand: bool = False
    """Whether it is a subsystem that was held by hand: a plan of its tasks, without an action."""
    stations: dict[str, str] = {}
    """Where each flow was carried out, by subsystem, where that was at several runtimes; then whoever had joined them
    wrote it, with the times at which it heard of things."""

    @property
    def plan_hash(self) -> str:
        """SHA-256 of the plan and the targets, code by its digests."""
        return hashlib.sha256(_bare(self.prepare)).hexdigest()

    def write(self, writer: Writer) -> None:
        """Put it at the beginning of a recording: the modules as files too, for whoever wants to read them."""
        writer.note(
            NOTE,
            {
                "version": "1",
                "application": self.prepare.plan.application,
                "plan": self.plan_hash,
                "seed": str(self.begin.seed),
                "time": "virtual" if self.is_virtual else "wall",
                "fresh": "yes" if self.is_fresh else "no",
                "began": self.began,
                "units": " ".join(self.rtpus),
                "options": " ".join(self.options),
                "software": self.software,
                **({_BY_HAND: "yes"} if self.is_by_hand else {}),
                **({_STATIONS: msgspec.json.encode(self.stations).decode()} if self.stations else {}),
            },
        )
        writer.attach(_PLAN, "application/json", _bare(self.prepare))
        writer.attach(_BEGIN, "application/json", msgspec.json.encode(self.begin))
        code = [(file.digest, file.module, file.path) for file in self.prepare.plan.code]
        writer.attach(_CODE, "application/json", msgspec.json.encode(code))
        for file in self.prepare.plan.code:
            writer.attach(_file(file.digest), "text/x-python", file.source.encode())

    @classmethod
    def read(cls, reader: Reader) -> "RunRecord":
        """Raises ValueError where the file says nothing of a run, or nothing that can be understood."""
        note = reader.notes.get(NOTE)
        plan, begin, code_list = (reader.attachment(name) for name in (_PLAN, _BEGIN, _CODE))
        if note is None or plan is None or begin is None or code_list is None:
            if not reader.is_whole:
                raise unfit(reader.path, Reason.of("record.no_run", given=_TOO_SHORT))
            raise unfit(reader.path, Reason.of("record.no_run", given=Reason.of("record.none_in_file")))
        if note.get("version") != "1":
            version = Reason.plain(str(note.get("version")))
            raise unfit(reader.path, Reason.of("record.other_version", given=version))
        try:
            code = [
                _code(reader, *code_file)
                for code_file in msgspec.json.decode(code_list, type=list[tuple[str, str, str]])
            ]
            prepare = msgspec.json.decode(plan, type=Prepare)
            begin_request = msgspec.json.decode(begin, type=Begin)
        except msgspec.MsgspecError as wrong:
            raise unfit(reader.path, Reason.of("record.no_plan", why=Reason.plain(str(wrong)))) from None
        prepare = structs.replace(prepare, plan=structs.replace(prepare.plan, code=tuple(code)))
        return cls(
            prepare,
            begin_request,
            _units(reader, note.get("units", "")),
            note.get("time") == "virtual",
            note.get("fresh") == "yes",
            note.get("began", ""),
            note.get("software", ""),
            _options(reader, note.get("options", "")),
            note.get(_BY_HAND) == "yes",
            _stations(reader, note.get(_STATIONS, "{}")),
        )


def is_by_hand(notes: Mapping[str, Mapping[str, str]]) -> bool:
    """Whether the notes of a recording say that it is of a subsystem that was held by hand."""
    return notes.get(NOTE, {}).get(_BY_HAND) == "yes"


def ending(result: Result) -> dict[str, str]:
    """How it ended, as it is noted at the end of its recording."""
    return {
        "completed": "yes" if result.completed else "no",
        "cause": str(result.cause),
        "hash": result.hash,
        "seconds": f"{result.runtime_s:.9g}",
        "outside": " ".join(result.outside),
    }


def closing(cause: Reason, seconds: float) -> dict[str, str]:
    """How the recording of a subsystem that was held by hand ended; it has no end of its own that could go badly."""
    return {"completed": "yes", "cause": str(cause), "hash": "", "seconds": f"{seconds:.9g}", "outside": ""}


def standing(cause: Reason) -> dict[str, str]:
    """Why it stood still, as it is noted at the end of a black box that is written while the run goes on."""
    return {"completed": "no", "goes_on": "yes", "cause": str(cause), "hash": "", "outside": ""}


def _units(reader: Reader, text: str) -> tuple[str, ...]:
    """The processing units; raises ValueError for what is no name of one: they become words of a command line."""
    units = tuple(text.split())
    wrong = [unit for unit in units if not TASK_NAME.match(unit)]
    if wrong or len(units) > _MOST_UNITS:
        raise unfit(reader.path, Reason.of("record.units", most=_MOST_UNITS, units=units[:_MOST_UNITS]))
    return units


def _options(reader: Reader, text: str) -> tuple[str, ...]:
    """The options of a runtime that recordings may name, and no others: a file gives no orders."""
    words = tuple(text.split())
    if not words or _OPTIONS.fullmatch(text):
        return words
    raise unfit(reader.path, Reason.of("record.options", text=text))


def _stations(reader: Reader, text: str) -> dict[str, str]:
    """Where flows were carried out; raises ValueError for what says nothing of that."""
    try:
        return msgspec.json.decode(text, type=dict[str, str])
    except msgspec.MsgspecError as wrong:
        raise unfit(reader.path, Reason.of("record.no_plan", why=Reason.plain(str(wrong)))) from None


def _code(reader: Reader, digest: str, module: str, path: str) -> Code:
    source = reader.attachment(_file(digest))
    if source is None:
        if not reader.is_whole:
            raise unfit(reader.path, Reason.of("record.no_run", given=_TOO_SHORT))
        raise unfit(reader.path, Reason.of("record.no_source", module=module))
    return Code(digest, module, path, source.decode())


def _bare(prepare: Prepare) -> bytes:
    bare: Any = structs.replace(prepare, plan=structs.replace(prepare.plan, code=()))
    return msgspec.json.encode(bare)


def _file(digest: str) -> str:
    return f"code/{digest}.py"
