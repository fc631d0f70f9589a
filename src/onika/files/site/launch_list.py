"""The launch list of a site: what may be launched there, and nothing else (requirement A15).

A format of our own in the style of Appendix A. It has no line for a command, a path or code: whoever may launch chooses
a name, and everything else is what the owner of the site has written.
"""

from collections.abc import Iterable, Mapping, Sequence

from onika.files.layout import carry_comments
from onika.files.line import FileLine, is_number, row, show_number, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.model.launch import UNITS, Launch
from onika.words.fault import Fault
from onika.words.name import TASK_NAME, WORLD_NAME
from onika.words.reason import Reason

SHORTEST_LEASE_S, LONGEST_LEASE_S = 0.2, 3.0
_HEAD = (KeywordSlot("VERSION"),)
_LAUNCH = (
    KeywordSlot("LAUNCH"),
    KeywordSlot("WORLD", Need.OPTIONAL, many=True),
    KeywordSlot("ROBOT", Need.OPTIONAL),
    KeywordSlot("BOOKING", Need.OPTIONAL),
    KeywordSlot("UNIT", Need.OPTIONAL, many=True),
    KeywordSlot("TIME", Need.OPTIONAL),
    KeywordSlot("PORT", Need.OPTIONAL),
    KeywordSlot("LEASE", Need.OPTIONAL),
    KeywordSlot("CODE", Need.OPTIONAL),
    KeywordSlot("STAYS", Need.OPTIONAL),
)
_LAST_PORT = 65535


def read(text: str, _name: str, place_file: str) -> tuple[tuple[Launch, ...] | None, tuple[Fault, ...]]:
    """What may be launched, all or nothing, in the order of the file."""
    reading = TextReading(place_file, Reason.of("files.no_launch_list"))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {"LAUNCH"})
    reading.arrange(head, _HEAD)
    launches: dict[str, Launch] = {}
    ports: set[int] = set()
    for block in blocks:
        launch = _launch(block, reading)
        if launch.name in launches:
            reading.fault(block[0].number, Reason.of("files.every_name_once", given=str(block[0])))
        if launch.port in ports:
            reading.fault(block[0].number, Reason.of("files.port_once", name=launch.name, port=launch.port))
        launches[launch.name] = launch
        ports |= {launch.port} - {0}
    if not blocks:
        reading.fault(reading.end, Reason.of("files.nothing_to_launch"))
    return (None if reading.broken else tuple(launches.values())), reading.faults


def write(launches: Iterable[Launch], former: str = "") -> str:
    """The text of a launch list, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED)]
    for launch in launches:
        parts += ["\n", row("LAUNCH", launch.name), *(row("WORLD", world) for world in launch.worlds)]
        parts += [row("ROBOT", launch.robot)] if launch.robot else []
        parts += [row("BOOKING", "needed")] if launch.needs_booking else []
        parts += [row("UNIT", unit) for unit in launch.units if launch.units != UNITS]
        parts += [row("TIME", "virtual")] if launch.is_virtual else []
        parts += [row("PORT", str(launch.port))] if launch.port else []
        parts += [row("LEASE", show_number(launch.lease_s), "s")] if launch.lease_s else []
        parts += [row("CODE", "yes")] if launch.takes_code else []
        parts += [row("STAYS", "yes")] if launch.stays else []
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _launch(block: Sequence[FileLine], reading: TextReading) -> Launch:
    by_keyword = reading.arrange(block, _LAUNCH)
    line = {keyword: lines[0] if lines else None for keyword, lines in by_keyword.items()}
    needs_booking = reading.choice(line["BOOKING"], {"free": False, "needed": True}, False)
    booking = line["BOOKING"]
    if booking is not None and needs_booking and line["ROBOT"] is None:
        reading.fault(booking.number, Reason.of("files.booking_of_robot", line=str(booking)))
    return Launch(
        name=reading.match(line["LAUNCH"], TASK_NAME, Reason.of("files.a_name")),
        worlds=_names(by_keyword, "WORLD", reading),
        robot=reading.match(line["ROBOT"], TASK_NAME, Reason.of("files.a_name")),
        units=_names(by_keyword, "UNIT", reading) or UNITS,
        port=_port(line["PORT"], reading),
        is_virtual=reading.choice(line["TIME"], {"wall": False, "virtual": True}, False),
        needs_booking=needs_booking,
        takes_code=reading.yes(line["CODE"], False),
        stays=reading.yes(line["STAYS"], False),
        lease_s=_lease(line["LEASE"], reading),
    )


def _names(by_keyword: Mapping[str, list[FileLine]], keyword: str, reading: TextReading) -> tuple[str, ...]:
    """The names in lines of a keyword that may stand several times."""
    pattern = WORLD_NAME if keyword == "WORLD" else TASK_NAME
    names = [reading.match(line, pattern, Reason.of("files.a_name")) for line in by_keyword[keyword]]
    return tuple(dict.fromkeys(names))


def _port(line: FileLine | None, reading: TextReading) -> int:
    port = reading.whole(line, 0, low=1)
    if line is not None and port > _LAST_PORT:
        reading.fault(line.number, Reason.of("files.port_expected", last=_LAST_PORT, line=str(line)))
    return port


def _lease(line: FileLine | None, reading: TextReading) -> float:
    """How long a holder may be silent, in s; 0 where nothing is said."""
    if line is None:
        return 0.0
    number = line.words[0] if line.words else ""
    seconds = float(number) if is_number(number) else 0.0
    if line.words[1:] not in ((), ("s",)) or not SHORTEST_LEASE_S <= seconds <= LONGEST_LEASE_S:
        limits = {"least": SHORTEST_LEASE_S, "most": LONGEST_LEASE_S}
        reading.fault(line.number, Reason.of("files.lease_expected", line=str(line), **limits))
    return seconds
