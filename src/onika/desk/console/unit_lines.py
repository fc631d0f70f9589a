"""Console commands about processing units: which there are, one more, a lost one anew (requirements A06, E10)."""

from onika.desk.console.session import ConsoleSession, Faults
from onika.wire import live
from onika.words.reason import Reason

Words = tuple[str, ...]
ADD = "add"


def rtpus(session: ConsoleSession, words: Words) -> Faults:
    """The processing units, whether they live, and their loads; or one more of them."""
    if not words:
        return _show(session)
    if len(words) != 2 or words[0] != ADD:
        return session.no(Reason.of("console.unit_words", words=" ".join(words)))
    faults = session.order(live.AddUnit(words[1]))
    session.hear()
    return faults


def _show(session: ConsoleSession) -> Faults:
    units = session.look_again().rtpus
    lost, alive = Reason.of("console.unit_lost"), Reason.of("console.unit_alive")
    rows = [(unit.name, lost if unit.is_lost else alive, f"{unit.load:.1%}") for unit in units]
    session.show_table((Reason.of("console.head_rtpu"), "", Reason.of("console.head_load")), rows)
    return ()
