from dataclasses import replace

from onika.desk.environment.reconcile.rollback import reverted, without_steps
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.history import History, UndoStep
from onika.model.configuration import Configuration, Group, Placed
from onika.words.reason import Reason


def test_what_a_step_did_is_taken_out_of_what_is_there_now():
    def content(*placed, **wanted):
        return Content(Configuration("c", placed), wanted)

    a, b, c = Placed("a"), Placed("b"), Placed("c")
    start, end = content(a, b, a=True, b=False), content(replace(a, frequency=5.0), c, a=False, c=False)
    assert reverted(end, start, end) == start
    now = content(replace(a, frequency=5.0, x=9), c, Placed("d"), a=False, c=False, d=True)
    assert reverted(now, start, end) == content(replace(a, x=9), Placed("d"), b, a=True, b=False, d=True)


def test_the_steps_of_what_failed_are_gone_and_later_ones_stay():  # R-X10
    content = Content(Configuration("c"))
    first, failed, later = (
        UndoStep(Reason.plain(name), "me", content, content) for name in ("first", "failed", "later")
    )
    before = History((first,))
    after = before.done(failed)
    assert without_steps(after, before, after) is before
    assert without_steps(after.done(later), before, after) == History((first, later))


def test_what_was_taken_back_in_vain_can_be_taken_back_again():  # R-X10
    content = Content(Configuration("c"))
    step = UndoStep(Reason.plain("turning a ON"), "me", content, content)
    before = History((step,))
    undone = before.undone(9)
    assert without_steps(undone, before, undone) is before


def test_a_supermodule_is_as_it_was_before_what_failed_but_for_what_was_done_to_it_since():  # R-C17, R-X10
    def content(names, **groups):
        placed = tuple(map(Placed, names))
        return Content(Configuration("c", placed, groups=tuple(Group(name, tuple(of)) for name, of in groups.items())))

    start, end = content("abcd", one="ab", two="cd"), content("bcd", one="b", two="cd")
    assert reverted(content("bcd", one="b", two="cd"), start, end) == content("bcda", one="ab", two="cd")
    assert reverted(content("bcd", one="b", two="dc"), start, end) == content("bcda", one="ab", two="dc")
    assert reverted(content("bcd", one="bc", two="d"), start, end) == content("bcda", one="bc", two="d")
    assert reverted(content("bcd", two="cd"), start, end) == content("bcda", two="cd")  # expanded since
    gone = content("cd", two="cd")
    assert reverted(content("cd", two="d"), start, gone) == content("cdab", two="d", one="ab")
    made = content("abcde", one="ab", two="cd", three="e")
    assert reverted(content("abcde", one="a", three="e", two="cd"), start, made) == content("abcd", one="a", two="cd")
