"""A.4, the application file, read naively. A target has no marks of its own here: they are its job's (decision 24)."""

from itertools import pairwise
from typing import Any

from .icon import Types, lines
from .script import Script, name, one_of, one_word, yes

HOLE = "hole"


def read(text: str, types: Types) -> dict[str, Any]:
    script = Script(text)
    kind = one_of(script.maybe("APPLTYPE", "conditional"), "conditional", "parallel")
    flows = []
    while script.next == "FLOW":
        _alone(script.take("FLOW"))
        steps: list[Any] = []
        while script.next in ("ROUTINE", "ICONHOLE"):
            if script.next == "ICONHOLE":
                _alone(script.take("ICONHOLE"))
                if steps[-1:] != [HOLE]:  # adjacent ones are one (decision 33)
                    steps.append(HOLE)
            else:
                icon = _icon(script, types)
                if icon["ONIKON"] not in ("application start", "application end"):  # implied (decision 46)
                    steps.append(icon)
        _alone(script.take("ENDFLOW"))
        flows.append(_paired(steps))
    script.end()
    if not flows:
        raise ValueError("no flow")
    return {"APPLTYPE": kind, "flows": flows}


def _icon(script: Script, types: Types) -> dict[str, Any]:
    routine = name(script.take("ROUTINE"))
    marker = yes(script.maybe("MARKER", "no"))
    synch = one_word(script.take("SYNCHTAG")) if script.next == "SYNCHTAG" else None
    tag, test = None, False
    if script.next == "WHILETAG":
        tag = one_word(script.take("WHILETAG"))
        test = yes(script.take("WHILETEST"))
    marks = {"ROUTINE": routine, "MARKER": marker, "SYNCHTAG": synch, "WHILETAG": tag, "WHILETEST": test}
    return {**marks, **lines(script, types)}


def _paired(steps: list[Any]) -> list[Any]:
    """A mark on a pair is the job's, wherever it stands."""
    for job, target in pairwise(steps):
        if HOLE in (job, target) or not _takes(job["ONIKON"]) or "object" not in target["ONIKON"].split():
            continue
        for tag in ("SYNCHTAG", "WHILETAG"):
            if None not in (job[tag], target[tag]) and job[tag] != target[tag]:
                raise ValueError(tag)
            job[tag], target[tag] = job[tag] if job[tag] is not None else target[tag], None
        for mark in ("MARKER", "WHILETEST"):
            job[mark], target[mark] = job[mark] or target[mark], False
    return steps


def _takes(kind: str) -> bool:
    """By its words: "job" or "application" without "Complete"."""
    words = kind.split()
    is_action = "job" in words or "application" in words
    return (
        is_action and not {"complete", "object"} & set(words) and kind not in ("application start", "application end")
    )


def _alone(text: str) -> None:
    if text:
        raise ValueError(text)
