"""Summarises a recording in a few lines: what was run, how it ended, and what the file holds."""

from collections.abc import Iterator

from onika.desk.run.run_review import Review
from onika.record.black_box_span import BlackBoxSpan
from onika.wire import event
from onika.words.reason import Reason


def digest_lines(review: Review) -> Iterator[Reason]:
    """Line by line."""
    run = review.run
    began = Reason.plain(run.began) if run.began else Reason.of("desk.digest_untimed")
    application, seed, software = run.prepare.plan.application, run.begin.seed, run.software
    if run.is_by_hand:
        key = "desk.digest_by_hand_virtual" if run.is_virtual else "desk.digest_by_hand_wall"
        yield Reason.of(key, subsystem=application, began=began, software=software)
    else:
        key = "desk.digest_run_virtual" if run.is_virtual else "desk.digest_run_wall"
        yield Reason.of(key, application=application, began=began, seed=seed, software=software)
    yield Reason.of("desk.digest_plan", plan=review.run.plan_hash[:16], units=" ".join(run.rtpus))
    for flow, station in run.stations.items():
        yield Reason.of("desk.digest_station", flow=flow, station=station)
    if review.black_box is not None:
        yield black_box_line(review.black_box, is_by_hand=run.is_by_hand)
    first, last = review.span_s
    variables, events = len(review.series), len(review.events)
    yield Reason.of("desk.digest_size", seconds=last - first, variables=variables, events=events)
    yield from _flows(review)
    yield from _troubles(review)
    yield from _ending(review)


def black_box_line(held: BlackBoxSpan, *, is_by_hand: bool) -> Reason:
    """What a black box is of, and of what time."""
    key = "desk.digest_black_box_fault" if held.goes_on else "desk.digest_black_box"
    if is_by_hand:
        key = "desk.digest_black_box_by_hand"
    return Reason.of(key, begin=held.begin_ns * 1e-9, end=held.end_ns * 1e-9)


def _flows(review: Review) -> Iterator[Reason]:
    """Of each flow how far it came, and its actions one by one."""
    for flow in review.flows if not review.run.is_by_hand else ():
        ended = [interval.action for interval in flow.intervals if interval.is_done]
        done, count = len(set(ended)), len(flow.actions)
        if len(ended) == done:
            yield Reason.of("desk.digest_flow", flow=flow.subsystem, done=done, count=count)
        else:  # a loop, a jump or a repeated step carries actions out more than once
            yield Reason.of("desk.digest_flow_again", flow=flow.subsystem, done=done, count=count, times=len(ended))
        for interval in flow.intervals:
            end = Reason.of("desk.digest_not_ended")
            if interval.end_s is not None:
                end = Reason.of("desk.digest_until", end_s=interval.end_s)
            is_left = interval.end_s is not None and not interval.is_done
            yield Reason.of(
                "desk.digest_interval_left" if is_left else "desk.digest_interval",
                begin=interval.begin_s,
                end=end,
                number=interval.action + 1,
                count=count,
                name=interval.name,
            )


def _troubles(review: Review) -> Iterator[Reason]:
    for at, subsystem, message in review.events:
        at_s = at * 1e-9
        if isinstance(message, event.Failed):
            task = f"{subsystem}/{message.task}"
            yield Reason.of("desk.digest_failed", at=at_s, task=task, text=message.text)
        elif isinstance(message, event.Lost):
            yield Reason.of("desk.digest_lost", at=at_s, name=message.name, cause=message.cause)


def _ended_by_hand(cause: str) -> Reason:
    """A recording by hand ends as somebody wishes, unless it says why."""
    if cause:
        return Reason.of("desk.digest_hand_ended_why", cause=cause)
    return Reason.of("desk.digest_hand_ended")


def _ending(review: Review) -> Iterator[Reason]:
    """How it ended, and what is not in the file."""
    ending = review.ending
    if not review.is_whole:
        yield Reason.of("desk.digest_cut")
    elif ending:
        how = Reason.of("desk.digest_completed")
        if review.run.is_by_hand and review.black_box is None:
            how = _ended_by_hand(ending.get("cause", ""))
        elif ending.get("completed") != "yes":
            stood = review.black_box is not None and review.black_box.goes_on
            key = "desk.digest_stood" if stood else "desk.digest_aborted"
            if review.run.is_by_hand:
                key = "desk.digest_went_wrong"
            how = Reason.of(key, cause=ending.get("cause", ""))
        yield Reason.of("desk.digest_hash", ending=how, hash=ending["hash"]) if ending.get("hash") else how
    if ending.get("missed", "0") != "0":
        yield Reason.of("desk.digest_missed", count=ending["missed"])
    if ending.get("untold", "0") != "0":
        yield Reason.of("desk.digest_untold", count=ending["untold"])
