"""Measure Onika beside its peers, print tables, and write them into the page of benchmarks if asked to."""

import argparse
import os
from collections.abc import Sequence
from pathlib import Path

from beside import machine, page
from beside.contest import hold
from beside.contestant import Absent
from beside.contests import CONTESTS, LADDERS
from beside.ladder import climb

COMMAND = "make bench-peers"


def measure(keys: Sequence[str], rounds: int, *, is_quick: bool, alone: bool) -> list[str]:
    """Carry out what is named, printing each table as it comes; the tables."""
    tables = []
    for contest in (one for one in CONTESTS if one.key in keys):
        try:
            tables.append(page.outcome_table(hold(contest, rounds, is_quick=is_quick, alone=alone)))
        except Absent as why:
            tables.append(page.left_out(contest.title, str(why)))
        print(tables[-1], end="\n\n", flush=True)
    for ladder in (one for one in LADDERS if one.key in keys):
        try:
            tables.append(page.ladder_table(ladder, climb(ladder, rounds, is_quick=is_quick)))
        except Absent as why:
            tables.append(page.left_out(ladder.title, str(why)))
        print(tables[-1], end="\n\n", flush=True)
    return tables


def main(words: Sequence[str] | None = None) -> None:
    """The command."""
    keys = [one.key for one in (*CONTESTS, *LADDERS)]
    parser = argparse.ArgumentParser(prog="python -m beside", description=__doc__)
    parser.add_argument("--rounds", type=int, default=7, help="rounds that count, interleaved (default 7)")
    parser.add_argument("--quick", action="store_true", help="tiny rounds: whether it works, not how fast")
    parser.add_argument("--alone", action="store_true", help="without peers")
    parser.add_argument("--only", nargs="+", choices=keys, default=keys, metavar="ROW", help=", ".join(keys))
    parser.add_argument("--write", type=Path, metavar="PAGE", help="put the tables into this page")
    given = parser.parse_args(words)
    if given.rounds < 1:
        parser.error(f"expected one round or more, found {given.rounds}")
    if given.write and (given.quick or given.alone or len(given.only) < len(keys)):
        parser.error("a page is written of all rows, beside all peers, in full rounds")
    described = machine.described()
    print(f"{described}; load {os.getloadavg()[0]:.2f}\n")
    tables = measure(given.only, given.rounds, is_quick=given.quick, alone=given.alone)
    if given.write:
        head = f"Command: `{COMMAND}`, {given.rounds} rounds. Machine: {described}."
        text = given.write.read_text(encoding="utf-8")
        given.write.write_text(page.put(text, "\n\n".join([head, *tables])), encoding="utf-8")


if __name__ == "__main__":
    main()
