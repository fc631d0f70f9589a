from onika.wire.lack_of_room import without_gap
from onika.words.reason import Reason


def of_task(task: str, why: Reason) -> Reason:
    """What a transaction says of one task."""
    return Reason.of("host.of_task", task=task, why=Reason.of("host.entry_failed", entry="spawn", why=why))


NO_GAP = Reason.of("runtime.no_gap", needs_ms=2.74, largest_ms=1.89)


def test_only_tasks_without_a_gap_are_named():  # law 21
    several = Reason.of("host.several", reasons=(of_task("a", NO_GAP), of_task("b", Reason.plain("no sensor"))))
    assert without_gap(Reason.of("console.change_refused", cause=several)) == ("a",)
    assert without_gap(of_task("b", Reason.plain("needs 2 ms"))) == ()
