"""A.2, the task configuration file, read naively."""

from typing import Any

from .parameters import parameter
from .script import Script, name, number, numbers, one_word, real, svar, words, yes

COUNTS = ("CONNS", "NUMINCONST", "NUMOUTCONST", "NUMINVAR", "NUMOUTVAR", "NUMDOUBLEIN")


def read(text: str) -> dict[str, Any]:
    script = Script(text, extended=True)
    tasks, loci, groups = [], [], []
    while script.next == "RMODFILE":
        file = name(script.take("RMODFILE"))
        own = script.new("AS")
        task = (
            file if own is None else name(own),
            _corner(script),
            yes(script.maybe("INLEFT", "yes")),
            real(script.maybe("FREQ", "0")),
            one_word(script.maybe("RTPU", "unknown")),
            file,
            _own_lines(script),
        )
        if task[3] < 0:
            raise ValueError("FREQ")
        tasks.append(task)
    while script.next == "LOCUS":
        where = svar(script.take("LOCUS")), _corner(script)
        counts = [number(script.maybe(count, "0")) for count in COUNTS]
        if min(counts) < 0:
            raise ValueError("counts")
        loci.append((*where, counts, yes(script.maybe("SHOW", "yes"))))
    while (group := script.new("GROUP")) is not None:
        groups.append([name(word) for word in words(group)])
    script.end()
    for heads in ([task[0] for task in tasks], [locus[0] for locus in loci]):
        if len(set(heads)) < len(heads):
            raise ValueError("twice")
    names = [task[0] for task in tasks]
    members = [member for group in groups for member in group[1:]]
    if len({group[0] for group in groups if group}) < len(groups) or len(set(members)) < len(members):
        raise ValueError("groups twice")
    if any(len(group) < 2 for group in groups) or any(member not in names for member in members):
        raise ValueError("groups of nothing")
    return {"tasks": tasks, "loci": loci, "groups": groups}


def _own_lines(script: Script) -> dict[str, Any]:
    own: dict[str, Any] = {"SVARALIAS": {}, "LOCAL": {}, "NOLOCAL": []}
    while (line := script.new("SVARALIAS")) is not None:
        coded, sign, other = line.replace("=", " = ").split()
        if sign != "=" or svar(coded) in own["SVARALIAS"]:
            raise ValueError("alias")
        own["SVARALIAS"][coded] = svar(other)
    while (line := script.new("LOCAL")) is not None:
        key, *parts = words(line)
        if parameter(key) in own["LOCAL"]:
            raise ValueError("parameter twice")
        own["LOCAL"][key] = parts
    while (line := script.new("NOLOCAL")) is not None:
        if parameter(line) in own["NOLOCAL"] or line in own["LOCAL"]:
            raise ValueError("parameter twice")
        own["NOLOCAL"].append(line)
    return own


def _corner(script: Script) -> tuple[int, int]:
    x, y = numbers(script.take("COORDS"))
    return x, y
