"""The application file, `.appl` (dissertation §A.4)."""

from onika.files.flow import DEEPEST, HEADS, depth, has_extensions, read_flows, write_flow
from onika.files.layout import carry_comments
from onika.files.line import row, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED, VERSION
from onika.model.application import Application
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".appl"

_HEAD = (KeywordSlot("VERSION", Need.OPTIONAL), KeywordSlot("APPLTYPE", Need.SINCE_1_3))
_MOST_LINES = 500_000
"""An application of ten thousand icons has four fifths of them."""


def read(text: str, name: str, place_file: str, syntax: Syntax) -> tuple[Application | None, tuple[Fault, ...]]:
    """The application `name` (no ending) of a text; left out with any fault.

    A target of unknown type leaves a hole that keeps its lines, a job of unknown type acts as a complete one
    (requirement D16).
    Start and end icons are left out (reading 46), adjacent holes are one (reading 33), the marks of a target go to
    its job (reading 24).
    """
    application, reading = _read(text, name, place_file, syntax)
    return (None if reading.broken else application), reading.faults


def salvage(text: str, name: str, place_file: str, syntax: Syntax) -> tuple[Application | None, tuple[Fault, ...]]:
    """The same as far as the text can be read, also with faults: an icon that cannot leaves a hole with its lines.

    None where there is no flow, where branches stand within each other too deep, where so much is wrong that the rest
    was not read, and where the text is of a newer version. Never to be run.
    """
    application, reading = _read(text, name, place_file, syntax)
    if application is None or reading.is_full or depth(application.flows) > DEEPEST:
        return None, reading.faults
    return application, reading.faults


def _read(text: str, name: str, place_file: str, syntax: Syntax) -> tuple[Application | None, TextReading]:
    reading = TextReading(place_file, Reason.of("files.application_left_out"), _MOST_LINES)
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading
    head, *blocks = split(reading.lines, HEADS)
    by_keyword = reading.arrange(head, _HEAD)
    kinds = {"parallel": True, "conditional": False}
    is_parallel = reading.choice(by_keyword["APPLTYPE"][0] if by_keyword["APPLTYPE"] else None, kinds, default=False)
    flows = read_flows(blocks, syntax, reading)
    if not flows:
        reading.fault(reading.end, Reason.of("files.flow_missing"))
    return (Application(name, is_parallel, flows) if flows else None), reading


def write(application: Application, former: str = "") -> str:
    """The text of an application, with the comments of its former text; of version 2.0 only where that is needed."""
    version = EXTENDED if any(map(has_extensions, application.flows)) else VERSION
    kind = "parallel" if application.is_parallel else "conditional"
    parts = [row("VERSION", version), row("APPLTYPE", kind), *map(write_flow, application.flows), row("EOF")]
    return carry_comments(former, "\n".join(parts))
