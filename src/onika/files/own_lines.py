"""The lines of a `.conf` that say of a placed task what its file says otherwise; of version 2.0 (requirement B09)."""

from collections.abc import Mapping, Sequence

from onika.files import rmod
from onika.files.line import FileLine, row
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.model.own_lines import OwnLines
from onika.model.task import LocalLine
from onika.words.reason import Reason

SLOTS = (
    KeywordSlot("SVARALIAS", Need.OF_2_0, many=True),
    KeywordSlot("LOCAL", Need.OF_2_0, many=True),
    KeywordSlot("NOLOCAL", Need.OF_2_0, many=True),
)


def read(by_keyword: Mapping[str, Sequence[FileLine]], reading: TextReading) -> OwnLines:
    """The lines of one task; each pin and each parameter stands in one of them."""
    local, without = by_keyword["LOCAL"], by_keyword["NOLOCAL"]
    seen: dict[str, FileLine] = {}
    for line in (*local, *without):
        key = line.words[0] if line.words else ""
        if not rmod.is_parameter(key) or (line.keyword == "NOLOCAL" and len(line.words) > 1):
            reading.fault(line.number, Reason.of("files.name_of_parameter", line=str(line)))
        elif seen.setdefault(key, line) is not line:
            reading.fault(line.number, Reason.of("files.keyword_once", keyword=key, line=str(line)))
    return OwnLines(
        rmod.aliases(by_keyword["SVARALIAS"], reading),
        tuple(LocalLine(line.words[0], line.words[1:]) for line in local if line.words),
        tuple(line.rest for line in without),
    )


def write(own: OwnLines) -> str:
    """The lines; none where the task is as its file says."""
    rows = [row("SVARALIAS", coded, "=", svar) for coded, svar in own.aliases]
    rows += [row("LOCAL", line.key, *line.words) for line in own.local]
    rows += [row("NOLOCAL", key) for key in own.without]
    return "".join(rows)
