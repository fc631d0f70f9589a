"""A fault of an application in the words of whoever builds it from pictures, without lines, files and step numbers."""

import re
from collections.abc import Callable, Iterable
from dataclasses import replace

from onika.desk.environment.outcome.remedy import plain
from onika.desk.plan.icon_names import in_words
from onika.words.fault import Fault

_AT = re.compile(r",? (?:at )?step \d+(?: of (?:flow \d+|`[^`]*`)(?:, step \d+, branch \d+)*(?: of `[^`]*`)?)?")
_NOWHERE = re.compile(r" (?:in|of) flow \d+(?:, step \d+, branch \d+)*\b")
EMPTY = re.compile(r"an action in flow (\d+)(?: of `.*`)?")
_INSTEAD = ("the application is not run", "nothing is run")
_SUPPLIERS = "one supplier of each constant in a flow"

_WAITING = r"waits at (\S+)(?: of .+?)? \([^)]*\)"
_WAITS = rf"(\S+) {_WAITING} for (\S+)"

_SAYINGS: tuple[tuple[str, str], ...] = (
    (r"edges that fit\|Application end behind (.+)", "nothing may end behind {0}: its edge fits no end"),
    (r"edges that fit\|(.+) behind Application start", "{0} does not fit at the start"),
    (r"edges that fit\|(.+) behind (.+)", "{0} does not fit behind {1}"),
    (r"an? (.+) behind it\|none behind (.+)", "{1} wants a {0} behind it"),
    (r"an action that takes this target\|none before (.+)", "no action before {0} takes it"),
    (r"the loop tag (.+) at two actions\|.*", "both marks of the loop {0} are at one action; they belong to two"),
    (r"the loop tag (.+) twice\|1 times.*", "the loop {0} is marked at one icon only; it has a test and an anchor"),
    (r"the loop tag (.+) twice\|(\d+) times.*", "the loop {0} is marked at {1} icons; it has a test and an anchor"),
    (
        r"exactly one test icon of the loop (.+)\|(\d+),.*",
        "the loop {0} has {1} tests; one of its icons is the test",
    ),
    (r"the condition of the loop (.+) at its test\|.*", "the condition of the loop {0} belongs at its test"),
    (r"loops that do not cross\|(.+)", "the loops {0} cross; one has to lie within the other"),
    (r"one loop tag at an action\|(.+) at (.+)", "{1} has two loop marks, {0}; an action bears one"),
    (
        r"a job on every way round the loop (.+)\|.*",
        "a way round the loop {0} takes no time: it needs a job",
    ),
    (r"the synchronisation tag (.+) in two flows .*", "the tag {0} stands in one flow only: nobody would be met there"),
    (r"a parallel application for the tag (.+)\|.*", "the tag {0} means nothing here: only parallel flows meet"),
    (
        rf"tags as often in each flow\|{_WAITS}, which has ended by then.*",
        "{0} could wait at the tag {1} in vain: {2} does not come there as often",
    ),
    (
        rf"tags in an order in which the flows can meet\|{_WAITS}, which {_WAITING} for \1.*",
        "{0} waits at the tag {1} for {2}, which waits at the tag {3} for {0}: neither comes",
    ),
    (r"a type the syntax defines\|(.+) of (.+)", "nothing is known of {1}'s type, {0}"),
    (r"an? (.+), as its trigger (.+) says\|(.+) for (.+)", "{3} is a {2} here, and its trigger {1} makes it a {0}"),
    (r"at least one flow\|.*", "it has no flow"),
    (r"an? (?:address|condition).*, as in.*\|(.+) at (.+)", "the condition {0} at {1} is none: compare a variable"),
    (r"a condition on a variable .*\|(.+) at (.+)", "the condition {0} asks for a variable that no task has there"),
    (r"module (\S+) once in a flow\|also in task (\S+)", "its module {0} is used already, by {1}"),
    (r"every module once in a flow\|(.+) in (.+)", "{1} have one module, {0}: they cannot live in one flow"),
    (r"every device claimed once in a flow\|(.+) by (.+)", "{1} both claim {0}: they cannot live in one flow"),
    (r"(\d+) conditions of a branch, or none\|(\d+).*", "this branch needs {0} conditions or none, and has {1}"),
    (rf"{_SUPPLIERS}\|(.+) from (.+)", "{1} cannot live in one flow: both give {0}"),
    (r"values for (.+)\|(.+?): (.+)", "{1} does not suit {0}: {2}"),
    (r"a target within reach\|(.+?): out of reach: (.+)", "{0} is out of reach: {1}"),
    (r"a target within reach\|(.+?): (.+)", "{0} cannot be reached: {1}"),
    (r"a posture of (\S+) where (\S+) would be\|(.+?): (?:out of reach: )?(.+)", "{0} cannot come to {2}: {3}"),
    (
        r"(?:poses of joint targets|postures for poses) from module (\S+)\|(.+?): none",
        "nothing is known of {1} from {0}",
    ),
    (r"a task with the outputs of (\S+), that works in its place\|(.+)", "{1}"),
    (r"a task of (.+?) \(.*\)\|(\S+)", "{0} does not use {1}"),
    (r"a task on the search path\|no (\S+)", "there is no task {0}"),
    (r"a device of world (\S+) \((.*)\)\|DEVICE (\S+)", "there is no device {2}; {0} has {1}"),
    (r"a world \((.*)\)\|DEVICE (\S+)", "there is no world for the device {1}, but {0}"),
    (r"the device that (\S+) means as (\S+)\|(.+)", "{1} is not the device that {0} means: {2}"),
    (r"devices of \S+ that can be used together\|(.+)", "{0}"),
    (r"device (\S+) for one task\|task (\S+) claims it too", "{1} and another task both claim {0}"),
    (
        r"the name (\S+) once on the search path\|it again, first in (.+)",
        "{0} stands twice on the search path; that of {1} is used",
    ),
    (r"a task that writes (\S+)\|only (.+), reading it", "nobody writes {0}, read by {1}; it keeps its last value"),
    (r"a task that (?:gives|supplies) the constants? (.+)\|(?:none|no such task).*", "no task gives the constant {0}"),
    (r"only ports that module (\S+) declares\|(.+)", "module {0} has no port {1}"),
    (r"(.+), as module (\S+) declares\|no such port", "its task has no port {0}, which module {1} declares"),
    (r"LOCAL .+\|(LOCAL .+: expected .+)", "{0}"),
    (r"(?:the|an?) (.+)\|none(?: for .*)?", "there is no {0}"),
)
"""Of `expected|found`, what is said; the first that fits counts."""

_TABLE: tuple[tuple[Callable[[str], re.Match[str] | None], str], ...] = tuple(
    (re.compile(pattern).fullmatch, words) for pattern, words in _SAYINGS
)


def said(fault: Fault) -> str:
    """A fault as a sentence."""
    if match := EMPTY.fullmatch(fault.expected):
        return f"flow {match[1]} is empty"
    instead = "" if fault.instead in _INSTEAD else f"; {fault.instead}"
    expected, found = (in_words(plain(_AT.sub("", _NOWHERE.sub("", one)))) for one in (fault.expected, fault.found))
    for fits, words in _TABLE:
        if match := fits(f"{expected}|{found}"):
            return words.format(*match.groups())
    return plain(f"expected {expected}, found {found}{instead}")


def together(faults: Iterable[Fault]) -> list[Fault]:
    """What two tasks have in common, told once with all of it: two arms in one flow share all their constants."""
    found: dict[object, Fault] = {}
    for one in faults:
        name, of, who = one.found.partition(" from ")
        key = (one.place, who) if one.expected == _SUPPLIERS and of else one
        former = found.get(key)
        joined = f"{former.found.removesuffix(of + who)}, {name}{of}{who}" if former and key is not one else one.found
        found[key] = replace(one, found=joined)
    return list(found.values())
