"""A.4, the application file, read naively. A target has no marks of its own here: they are its job's (reading 24)."""

from typing import Any

from .icon import Types, lines
from .script import Script, condition, name, one_of, one_word, yes

HOLE = "hole"


def read(text: str, types: Types) -> dict[str, Any]:
    script = Script(text, extended=True)
    kind = one_of(script.maybe("APPLTYPE", "conditional"), "conditional", "parallel")
    flows = []
    while script.next == "FLOW":
        _alone(script.take("FLOW"))
        flows.append(_steps(script, types))
    script.end()
    if not flows:
        raise ValueError("no flow")
    return {"APPLTYPE": kind, "flows": flows}


def _steps(script: Script, types: Types) -> list[Any]:
    """What stands behind FLOW, and its end."""
    steps: list[Any] = []
    while script.next in ("ROUTINE", "ICONHOLE", "BRANCH"):
        if script.next == "ICONHOLE":
            _alone(script.take("ICONHOLE"))
            if steps[-1:] != [HOLE]:  # adjacent ones are one (reading 33)
                steps.append(HOLE)
        elif script.next == "BRANCH":
            steps.append(_branch(script, types))
        else:
            icon = _icon(script, types)
            if icon["ONIKON"] not in ("application start", "application end"):  # implied (reading 46)
                steps.append(icon)
    _alone(script.take("ENDFLOW"))
    return _paired(steps)


def _branch(script: Script, types: Types) -> dict[str, Any]:
    _alone(script.new("BRANCH") or "")
    heads, flows = [], []
    while script.next == "FLOW":
        heads.append(script.take("FLOW"))
        flows.append(_steps(script, types))
    _alone(script.new("ENDBRANCH") or "" if script.next == "ENDBRANCH" else script.take("ENDBRANCH"))
    chosen = [condition(head) for head in heads if head]
    if not flows or (chosen and (len(chosen) != len(heads) - 1 or heads[-1])):
        raise ValueError("branch")
    return {"BRANCH": flows, "IF": chosen}


def _icon(script: Script, types: Types) -> dict[str, Any]:
    routine = name(script.take("ROUTINE"))
    marker = yes(script.maybe("MARKER", "no"))
    marker_if = _condition(script, "MARKERIF")
    synch = one_word(script.take("SYNCHTAG")) if script.next == "SYNCHTAG" else None
    tag, test, while_if = None, False, ""
    if script.next == "WHILETAG":
        tag = one_word(script.take("WHILETAG"))
        test = yes(script.take("WHILETEST"))
        while_if = _condition(script, "WHILEIF")
    marks = {"ROUTINE": routine, "MARKER": marker, "MARKERIF": marker_if, "SYNCHTAG": synch}
    return {**marks, "WHILETAG": tag, "WHILETEST": test, "WHILEIF": while_if, **lines(script, types)}


def _condition(script: Script, keyword: str) -> str:
    text = script.new(keyword)
    return "" if text is None else condition(text)


def _paired(steps: list[Any]) -> list[Any]:
    """A mark on an action is its job's, wherever it stands: on it or on one of its targets."""
    for at, job in enumerate(steps):
        for target in _targets(steps, at) if _is_icon(job) and _takes(job["ONIKON"]) else []:
            for tag in ("SYNCHTAG", "WHILETAG"):
                if None not in (job[tag], target[tag]) and job[tag] != target[tag]:
                    raise ValueError(tag)
                job[tag], target[tag] = job[tag] if job[tag] is not None else target[tag], None
            if job["WHILEIF"] and target["WHILEIF"] and job["WHILEIF"] != target["WHILEIF"]:
                raise ValueError("WHILEIF")
            job["WHILEIF"], target["WHILEIF"] = job["WHILEIF"] or target["WHILEIF"], ""
            if job["MARKER"] and target["MARKER"]:
                if job["MARKERIF"] != target["MARKERIF"]:
                    raise ValueError("MARKERIF")
            elif target["MARKER"]:
                job["MARKERIF"] = target["MARKERIF"]
            elif not job["MARKER"]:
                job["MARKERIF"] = job["MARKERIF"] or target["MARKERIF"]
            target["MARKERIF"] = ""
            for mark in ("MARKER", "WHILETEST"):
                job[mark], target[mark] = job[mark] or target[mark], False
    return steps


def _is_icon(step: Any) -> bool:
    return step != HOLE and "ROUTINE" in step


def _targets(steps: list[Any], at: int) -> list[Any]:
    """The targets behind a job, as far as it wants them; a hole stands for all it wants before what follows it."""
    job = steps[at]
    wanted = [" ".join("object" if w in ("job", "application") else w for w in job["ONIKON"].split()), *job["TARGET"]]
    result = []
    for number, step in enumerate(steps[at + 1 :], start=at + 1):
        if not wanted:
            break
        if step == HOLE:
            after = steps[number + 1] if number + 1 < len(steps) else HOLE
            if not _is_target(after):
                break
            skipped = wanted.index(after["ONIKON"], 1) if after["ONIKON"] in wanted[1:] else 1
            wanted = wanted[skipped:]
        elif _is_target(step):
            result.append(step)
            wanted = wanted[1:]
        else:
            break
    return result


def _is_target(step: Any) -> bool:
    return _is_icon(step) and "object" in step["ONIKON"].split()


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
