"""The console command `scope`: variables at every cycle, written as a table for other programs (C14, C27)."""

from pathlib import Path

from onika.desk.console.display import Tone
from onika.desk.console.inspection import refused
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.task_lines import positive
from onika.desk.console.time_lines import pass_time
from onika.desk.run.sample_series import SampleSeries, csv
from onika.files import whole
from onika.wire.samples import MOST_VARIABLES, Sample, Sampled
from onika.words.fault import Refusal
from onika.words.reason import Reason

Words = tuple[str, ...]
_ASKED_EVERY_S = 0.25
_MOST_S = 3600.0
_BEHIND_NS = 1_000_000_000
"""Of a variable whose newest value is older, more may be left to be sent."""


def scope(session: ConsoleSession, words: Words) -> Faults:
    """Take so many seconds of variables at every cycle and write them to a file; an old one is replaced."""
    path, seconds = Path(words[0]).expanduser(), positive(words[1])
    if seconds is None or seconds > _MOST_S:
        return session.no(Reason.of("console.scope_seconds", word=words[1], most=_MOST_S))
    if len(words) - 2 > MOST_VARIABLES:
        return session.no(Reason.of("console.scope_variables", most=MOST_VARIABLES))
    series = [SampleSeries("/".join(session.address(word))) for word in dict.fromkeys(words[2:])]
    faults = _follow(session, series, seconds)
    return faults or _write(session, path, series)


def _follow(session: ConsoleSession, series: list[SampleSeries], seconds: float) -> Faults:
    """Ask again and again until the time is over; what came before and after it is left out."""
    begin_ns, faults = _ask(session, series)
    end_ns = begin_ns + round(seconds * 1e9)
    now_ns = begin_ns
    while not faults and now_ns < end_ns:
        faults = pass_time(session, min((end_ns - now_ns) * 1e-9, _ASKED_EVERY_S))
        if not faults:
            now_ns, faults = _ask(session, series)
    for one in series:
        one.cut(begin_ns, end_ns)
    return faults


def _ask(session: ConsoleSession, series: list[SampleSeries]) -> tuple[int, Faults]:
    """Take what has come until now; the runtime's time in ns."""
    now_ns = -1
    behind = series
    while behind:
        answer = session.ask(Sample(tuple(one.variable for one in behind), tuple(one.last for one in behind)))
        if not isinstance(answer, Sampled):
            return 0, refused(session, Reason.of("console.scope_values"), answer)
        gone = next((trace.reason for trace in answer.traces if trace.reason), None)
        if gone is not None:
            return 0, session.no(gone, Reason.of("desk.nothing_written"))
        if now_ns < 0:
            now_ns = answer.now_ns
        came = [(one, one.take(trace)) for one, trace in zip(behind, answer.traces, strict=True)]
        behind = [one for one, is_more in came if is_more and one.times[-1] < now_ns - _BEHIND_NS]
    return now_ns, ()


def _write(session: ConsoleSession, path: Path, series: list[SampleSeries]) -> Faults:
    origin_ns = min((one.times[0] for one in series if one.times), default=0)
    written = whole.write(path, csv(series, origin_ns), whole.ANYTHING)
    if isinstance(written, Refusal):
        return session.no(Reason.of("console.unwritable", reason=written.sentence), Reason.of("desk.nothing_written"))
    count = sum(len(one.rows) for one in series)
    session.say(Reason.of("console.scope_written", path=str(path), count=count))
    for one in series:
        if one.missed:
            session.say(Reason.of("console.scope_missed", name=one.variable, count=one.missed), Tone.FAULT)
    return ()
