"""Writes the outcome of tests as JUnit XML, for build servers (requirement X07)."""

import re
from collections.abc import Sequence
from xml.etree import ElementTree

from onika.desk.trial.trial import Trial

_UNPRINTABLE = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")


def document(trials: Sequence[Trial]) -> bytes:
    """One suite with a case for each test: its failures, its notes as output."""
    failed = sum(not trial.verdict.is_passed for trial in trials)
    seconds = sum(trial.wall_s for trial in trials)
    count = {"tests": str(len(trials)), "failures": str(failed), "errors": "0", "time": f"{seconds:.3f}"}
    root = ElementTree.Element("testsuites", count)
    suite = ElementTree.SubElement(root, "testsuite", {"name": "onika", **count})
    for trial in trials:
        name = {"name": _clean(str(trial.name)), "classname": "onika", "time": f"{trial.wall_s:.3f}"}
        case = ElementTree.SubElement(suite, "testcase", name)
        if not trial.verdict.is_passed:
            failure = ElementTree.SubElement(case, "failure", {"message": _clean(str(trial.verdict.failures[0]))})
            failure.text = _clean("\n".join(map(str, trial.verdict.failures)))
        if trial.verdict.notes:
            ElementTree.SubElement(case, "system-out").text = _clean("\n".join(map(str, trial.verdict.notes)))
    ElementTree.indent(root)
    text: bytes = ElementTree.tostring(root, "utf-8", xml_declaration=True)
    return text + b"\n"


def _clean(text: str) -> str:
    return _UNPRINTABLE.sub("\ufffd", text)
