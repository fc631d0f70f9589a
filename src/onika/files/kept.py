"""The test file, `.test`: a kept run, in a format of our own in the style of Appendix A (requirement X07)."""

import math
import re
from collections.abc import Mapping, Sequence

from onika.files.layout import carry_comments
from onika.files.line import FileLine, is_number, row, show_number, split
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.files.version import EXTENDED
from onika.model.kept import Demand, KeptAction, KeptFlow, KeptMeeting, KeptRun
from onika.model.redirect import Redirect
from onika.words.condition import Condition
from onika.words.fault import Fault
from onika.words.reason import Reason

ENDING = ".test"

_HEAD = (
    KeywordSlot("VERSION"),
    KeywordSlot("APPLICATION"),
    KeywordSlot("DIGEST", Need.OPTIONAL),
    KeywordSlot("SEED", Need.OPTIONAL),
    KeywordSlot("SETTLE", Need.OPTIONAL),
    KeywordSlot("REDIRECT", Need.OPTIONAL, many=True),
    KeywordSlot("ANSWER", Need.OPTIONAL, many=True),
    KeywordSlot("EXPECT", Need.OPTIONAL, many=True),
)
_FLOW = (KeywordSlot("FLOW"), KeywordSlot("ROBOT", Need.OPTIONAL, many=True))
_ACTION = (
    KeywordSlot("ACTION"),
    KeywordSlot("LASTS"),
    KeywordSlot("ONTHEWAY", Need.OPTIONAL),
    KeywordSlot("AFTER", Need.OPTIONAL, many=True),
)
_END = (KeywordSlot("END"), KeywordSlot("AFTER", Need.OPTIONAL, many=True))
_MEET = (KeywordSlot("MEET"),)
_ADDRESS = re.compile(r"[A-Z][A-Z0-9_^]*(?:\[[0-9]+\])?\Z")
_PLUS_MINUS = ("+-", "±")


def read(text: str, name: str, place_file: str) -> tuple[KeptRun | None, tuple[Fault, ...]]:
    """The kept run of a text; left out with any fault. `name` completes the form of all formats."""
    reading = TextReading(place_file, Reason.of("files.test_left_out", name=name))
    reading.open_versioned(text, extended=True)
    if reading.is_over:
        return None, reading.faults
    head, *blocks = split(reading.lines, {"FLOW", "ACTION", "END", "MEET"})
    by_keyword = reading.arrange(head, _HEAD)
    single = {keyword: lines[0] if lines else None for keyword, lines in by_keyword.items()}
    flows, meetings = _body(blocks, reading)
    kept = KeptRun(
        application=reading.word(single["APPLICATION"], Reason.of("files.name_of_application")),
        digest=reading.word(single["DIGEST"], Reason.of("files.digest_of_application")),
        flows=flows,
        meetings=meetings,
        seed=reading.whole(single["SEED"], 0),
        settle_s=_quantity(single["SETTLE"], 0.5, reading)[0],
        redirects=tuple(redirect for line in by_keyword["REDIRECT"] if (redirect := _redirect(line, reading))),
        answers=tuple(answer for line in by_keyword["ANSWER"] if (answer := _answer(line, reading))),
        expectations=tuple(text for line in by_keyword["EXPECT"] if (text := _expectation(line, reading))),
    )
    if not flows:
        reading.fault(reading.end, Reason.of("files.flow_missing"))
    return (None if reading.broken else kept), reading.faults


def write(kept: KeptRun, former: str = "") -> str:
    """The text of a kept run, with the comments of its former text."""
    parts = [row("VERSION", EXTENDED), "\n", row("APPLICATION", kept.application)]
    parts += [row("DIGEST", kept.digest)] if kept.digest else []
    parts += [row("SEED", str(kept.seed)), row("SETTLE", show_number(kept.settle_s), "s")]
    parts += [row("REDIRECT", redirect) for redirect in kept.redirects]
    parts += [row("ANSWER", *answer) for answer in kept.answers]
    parts += [row("EXPECT", text) for text in kept.expectations]
    for flow in kept.flows:
        parts += ["\n", row("FLOW", flow.subsystem), *(row("ROBOT", *robot) for robot in flow.robots)]
        parts += [_show_action(action) for action in flow.actions]
        parts += ["\n", row("END"), *map(_show_demand, flow.at_end)]
    parts += ["\n"] if kept.meetings else []
    parts += [row("MEET", meeting.tag, *meeting.subsystems) for meeting in kept.meetings]
    return carry_comments(former, "".join([*parts, "\n", row("EOF")]))


def _show_action(action: KeptAction) -> str:
    lasts = row("LASTS", show_number(action.lasts_s), "s", "+-", show_number(action.within_s))
    way = row("ONTHEWAY", "yes") if action.is_on_way else ""
    return "\n" + row("ACTION", action.name) + lasts + way + "".join(map(_show_demand, action.after))


def _show_demand(demand: Demand) -> str:
    words = [demand.address, *map(show_number, demand.values)]
    words += [demand.unit] if demand.unit else []
    words += ["+-", show_number(demand.tolerance)] if demand.tolerance else []
    return row("AFTER", *words)


def _body(
    blocks: Sequence[Sequence[FileLine]], reading: TextReading
) -> tuple[tuple[KeptFlow, ...], tuple[KeptMeeting, ...]]:
    flows: list[KeptFlow] = []
    meetings = []
    actions: list[KeptAction] = []
    is_open = False
    for block in blocks:
        keyword, number = block[0].keyword, block[0].number
        if keyword == "MEET":
            meetings += _meeting(reading.arrange(block, _MEET)["MEET"], reading)
        elif keyword == "FLOW":
            if is_open:
                reading.fault(number, Reason.of("files.end_of_flow_before", block=str(block[0])))
            flows.append(_flow(reading.arrange(block, _FLOW), reading))
            actions, is_open = [], True
        elif not is_open:
            reading.fault(number, Reason.of("files.flow_before", keyword=keyword, block=str(block[0])))
        elif keyword == "ACTION":
            actions.append(_action(reading.arrange(block, _ACTION), reading))
        else:
            by_keyword = reading.arrange(block, _END)
            reading.bare(block[0])
            flow = flows[-1]
            flows[-1] = KeptFlow(flow.subsystem, flow.robots, tuple(actions), _demands(by_keyword["AFTER"], reading))
            is_open = False
    if is_open:
        reading.fault(reading.end, Reason.of("files.end_of_last_flow"))
    return tuple(flows), tuple(meetings)


def _flow(by_keyword: Mapping[str, list[FileLine]], reading: TextReading) -> KeptFlow:
    robots = []
    for line in by_keyword["ROBOT"]:
        if len(line.words) == 2:
            robots.append((line.words[0], line.words[1]))
        else:
            reading.fault(line.number, Reason.of("files.kept_robot", line=str(line)))
    return KeptFlow(
        reading.word(next(iter(by_keyword["FLOW"]), None), Reason.of("files.name_of_subsystem")), tuple(robots)
    )


def _action(by_keyword: Mapping[str, list[FileLine]], reading: TextReading) -> KeptAction:
    name, lasts, way = (next(iter(by_keyword[keyword]), None) for keyword in ("ACTION", "LASTS", "ONTHEWAY"))
    if name is not None and not name.rest:
        reading.fault(name.number, Reason.of("files.action_name", name=str(name)))
    lasts_s, within_s = _quantity(lasts, 0.0, reading)
    is_on_way = reading.yes(way, default=False)
    return KeptAction(name.text if name else "", lasts_s, within_s, _demands(by_keyword["AFTER"], reading), is_on_way)


def _demands(lines: Sequence[FileLine], reading: TextReading) -> tuple[Demand, ...]:
    return tuple(demand for line in lines if (demand := _demand(line, reading)))


def _demand(line: FileLine, reading: TextReading) -> Demand | None:
    """`Q_MEZ 0.5 -1.2 rad +- 0.005`; unit and tolerance may be left out."""
    address, *behind = line.words or ("",)
    words, tolerance = _tolerance(behind)
    count = next((at for at, word in enumerate(words) if not is_number(word)), len(words))
    unit = words[count:]
    is_sound = _ADDRESS.match(address) and count and len(unit) <= 1 and 0 <= tolerance < math.inf
    values = tuple(map(float, words[:count]))
    if not is_sound or not all(map(math.isfinite, values)):
        reading.fault(line.number, Reason.of("files.kept_values", keyword=line.keyword, line=str(line)))
        return None
    return Demand(address, values, unit[0] if unit else "", tolerance)


def _quantity(line: FileLine | None, default: float, reading: TextReading) -> tuple[float, float]:
    """`2.3 s +- 0.05`: seconds and how exactly."""
    if line is None:
        return default, 0.0
    words, tolerance = _tolerance(line.words)
    is_sound = len(words) in (1, 2) and is_number(words[0]) and words[1:] in ((), ("s",)) and tolerance >= 0
    if not is_sound or not 0 <= float(words[0]) < math.inf or not math.isfinite(tolerance):
        reading.fault(line.number, Reason.of("files.kept_seconds", keyword=line.keyword, line=str(line)))
        return default, 0.0
    return float(words[0]), tolerance


def _tolerance(words: Sequence[str]) -> tuple[tuple[str, ...], float]:
    """The words before `+-`, and the number behind it; -1 where that is none."""
    at = next((at for at, word in enumerate(words) if word in _PLUS_MINUS), len(words))
    behind = words[at + 1 :]
    if at == len(words):
        return tuple(words), 0.0
    return tuple(words[:at]), float(behind[0]) if len(behind) == 1 and is_number(behind[0]) else -1.0


def _answer(line: FileLine, reading: TextReading) -> tuple[str, str, str] | None:
    if len(line.words) < 3:
        reading.fault(line.number, Reason.of("files.kept_answer", line=str(line)))
        return None
    task, name, *values = line.words
    return task, name, " ".join(values)


def _expectation(line: FileLine, reading: TextReading) -> str:
    try:
        return Condition.parse(line.text).text
    except ValueError:
        reading.fault(line.number, Reason.of("files.kept_expect", line=str(line)))
        return ""


def _redirect(line: FileLine, reading: TextReading) -> str:
    try:
        return str(Redirect.parse(line.text))
    except ValueError:
        reading.fault(line.number, Reason.of("files.kept_redirect", line=str(line)))
        return ""


def _meeting(lines: Sequence[FileLine], reading: TextReading) -> list[KeptMeeting]:
    numbers = []
    for line in lines:
        if len(line.words) < 2:
            reading.fault(line.number, Reason.of("files.kept_meet", line=str(line)))
        else:
            numbers.append(KeptMeeting(line.words[0], line.words[1:]))
    return numbers
