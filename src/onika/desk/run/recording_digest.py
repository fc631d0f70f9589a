"""Summarises a recording in a few lines: what was run, how it ended, and what the file holds."""

from collections.abc import Iterator

from onika.desk.run.run_review import Review
from onika.wire import event


def digest_lines(review: Review) -> Iterator[str]:
    """Line by line."""
    run, ending = review.run, review.ending
    began = run.began or "at a time not told"
    time = "virtual" if run.is_virtual else "wall"
    yield f"{run.prepare.plan.application}, in {time} time, begun {began}, seed {run.begin.seed}, onika {run.software}"
    yield f"plan {run.plan_hash[:16]}, units {' '.join(run.rtpus)}"
    first, last = review.span_s
    yield f"{last - first:.9g} s recorded, {len(review.series)} variables, {len(review.events)} events"
    for flow in review.flows:
        ended = sum(interval.end_s is not None for interval in flow.intervals)
        yield f"{flow.subsystem}: {ended} of {len(flow.actions)} actions done"
        for interval in flow.intervals:
            end = "not ended" if interval.end_s is None else f"{interval.end_s:9.3f} s"
            yield f"  {interval.begin_s:9.3f} s to {end}  {interval.action + 1}/{len(flow.actions)}  {interval.name}"
    yield from _troubles(review)
    if not review.is_whole:
        yield "the file was cut short: what is in it ends where the last whole part of it does"
    elif ending:
        how = "completed" if ending.get("completed") == "yes" else f"aborted: {ending.get('cause', '')}"
        yield f"{how}{', hash ' + ending['hash'] if ending.get('hash') else ''}"
    for key, text in (("missed", "values were written over before they were seen"), ("untold", "words had no room")):
        if ending.get(key, "0") != "0":
            yield f"{ending[key]} {text}"


def _troubles(review: Review) -> Iterator[str]:
    for at, subsystem, message in review.events:
        if isinstance(message, event.Failed):
            yield f"{at * 1e-9:9.3f} s  {subsystem}/{message.task} failed: {message.text}"
        elif isinstance(message, event.Lost):
            yield f"{at * 1e-9:9.3f} s  {message.name} was lost: {message.cause}"
