"""Nothing waits by the clock of the day: it may jump, by an hour or by a second, and no lease or deadline with it.

The few files that look at it write down when something happened, for people to read; one asks how old files are, one
how long what somebody has signed holds, one whose time it is by what is booked.
"""

import ast
import re
from pathlib import Path

import onika

HOUSE = Path(onika.__file__).parent
OF_PEOPLE = {
    "agent/program.py",
    "cli/fabric/command.py",
    "cli/library/command.py",
    "cli/library/sending.py",
    "cli/own.py",
    "desk/console/readings_log.py",
    "desk/environment/diary.py",
    "desk/environment/outcome/services.py",
    "desk/joined/joint_recording.py",
    "host/recording/black_box.py",
    "host/recording/run_description.py",
    "host/sessions/site_clock.py",
    "labs/folders/module/only_files.py",
    "store/audit_trail.py",
    "web/hub.py",
}
OF_THE_DAY = {("time", "time"), ("time", "time_ns"), ("datetime", "now"), ("datetime", "utcnow"), ("date", "today")}


CLOCKS = re.compile(r"\b(?:import|from) (?:time|datetime)\b")


def looks_at_the_day(source: str) -> bool:
    if CLOCKS.search(source) is None:
        return False
    names = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            names.add((node.value.id, node.attr))
        elif isinstance(node, ast.ImportFrom) and node.module == "time":
            names |= {("time", alias.name) for alias in node.names}
    return bool(names & OF_THE_DAY)


def test_only_what_tells_people_when_something_was_looks_at_the_clock_of_the_day():  # R-F01
    files = {str(path.relative_to(HOUSE)) for path in HOUSE.rglob("*.py") if looks_at_the_day(path.read_text())}
    assert files == OF_PEOPLE


def test_a_file_that_would_wait_by_it_is_noticed():
    assert looks_at_the_day("import time\nuntil = time.time() + 3")
    assert looks_at_the_day("from time import time_ns")
    assert not looks_at_the_day("from time import monotonic_ns\nuntil = monotonic_ns()")
