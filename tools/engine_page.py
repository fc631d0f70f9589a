"""The page of the engine: how flows wait, loop, stop and go on, and how that is proved; its diagram is the table's."""

from onika.engine import flow
from onika.model.rules import meetings

_PAGE = """\
# The engine

The engine carries out applications. It is fed news (a task is ON, a trigger has finished, the user wants a pause) and
answers with orders (a switch, a clear, a kill); it has no clock, thread or socket, so that everything on this page
can be tested as a story. Each flow is a program of ten instructions ([decision
18](decisions/0018-a-flow-is-a-program-of-ten-instructions.md)). The diagram is drawn from its table by `python
tools/generate.py`.

## The life of a flow

```mermaid
{diagram}```

Out of *spawning*, *running*, *waiting*, *joining*, *paused*, *clearing* and *done* a flow can come into nearly every
other state: what comes next in its program decides, or its user.

## Tags: who waits for whom

- A tag is met by all flows in whose programs it stands; the n-th visit of one flow meets the n-th of each other. All
  go on together, in one switch.
- Who was let pass (`pass`) has been there. Who paused at the tag, or stopped there, has not come yet.
- A nested parallel application has tags of its own, each time it is begun anew.
- A flow that waits for one that has ended waits until the user lets it pass; the message says so.

## Loops, branches, no-ops

- A test, or a branch without conditions, looks at the value of the last action that was carried out, nested ones
  included. At the beginning and after a skip there is no value: loops are left, branches take flow 0. A value beyond
  the flows takes flow 0, with a warning.
- A no-op takes no time and returns "flow 0, go on". A loop of nothing else is a fault before the run.
- `leave` marks the innermost loop: it is left at its next test, whatever that says.

## Pauses, skips, errors

- A pause comes after the current action; a flow that waits pauses at once. A breakpoint pauses every time, no-ops
  included.
- A skip ends the current action at once: its trigger goes off, all others hold, the flow goes on at the chosen
  action.
- A task that fails stops its flow: the trigger goes off at once, the others run on to their next tag. `recover`
  clears what is in error, then one switch repeats the step with the same target. A failure elsewhere than in an
  action puts the flow back to where it was.
- An abort kills every task, whatever the flows do, and the end is said when all are gone.

## Deadlocks before the run

`model/rules/meetings.py` looks at every state that the flows of a plan can come to: every choice of a loop or branch
is free unless its value is known, and only places where a flow waits count. Flows without tags in common are looked
at apart. A deadlock to which every run comes is a fault and nothing moves; one that depends on choices is a note with
an example; more than {limit:,} states are not looked at, and that is said. Straight programs take time in proportion
to their length.

## How it is proved

| what | where |
|---|---|
| stories of every rule: news in, orders out | `tests/play`, `tests/engine` |
| the check of deadlocks beside a plain search, on random programs | `tests/model/rules/test_waits.py` |
| small programs with **every** interleaving of news, user and faults | `tests/play/test_explored.py` |
| random applications beside a small engine that walks their trees | `tests/play/test_against_model.py` |
| mistakes planted in the engine, each of which must be found | `tests/play/test_planted.py` |

What the exploration lets happen, in any order and arbitrarily late: tasks are spawned, come on, finish with every
value that makes a difference, finish with the prepared switch; once, or in the long run twice, the user pauses,
resumes, steps, skips to every action, passes, leaves, recovers; once a task fails, refuses to be spawned, to come on
or to be cleared, says something twice, goes off by itself or is gone.

What it demands after every single word: a finish of the present activation is never lost, no other one ends an
action; no action begins twice but by recovering; no order that a task could not obey; a flow of which all is heard
has exactly the tasks ON that its action wants, and never a trigger ON while it does not run. And from every state: an
abort ends the run with every task gone; with the help of its user the run can be completed. Where nobody interferes,
a program comes to stand still if and only if the check foretold it.

What it does not show: what the runtime does with the orders (that is the law of the runtime, and tests of its own),
programs of more than three flows, three tasks each, and more than two disturbances in one run; for these there are
only the random applications. The theatre hears nothing that a task said before it was told to come on anew, except
that it failed or is gone; the runtime must see to that.
"""


def page() -> str:
    """The whole page."""
    return _PAGE.format(diagram=flow.diagram(), limit=meetings.LIMIT)
