"""Whatever sessions do in whatever order, one at most may change a subsystem: compared with a rule said in short."""

from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.runtime.live_edits import live_edits_with_tasks
from kit.runtime.sessions import SECOND, leave, silent, there
from onika.wire import holding, live, request
from onika.words.reason import Reason

SESSIONS = ("one", "two", "three")
DEEDS = st.tuples(
    st.sampled_from(
        (
            "take",
            "take",
            "hand",
            "hand",
            "turn",
            "turn",
            "silent",
            "release",
            "decline",
            "leave",
            "watch",
            "stop",
            "reset",
        )
    ),
    st.sampled_from(SESSIONS),
    st.sampled_from(SESSIONS),
)


class Rule:
    """Who holds the subsystem, said once more and in short: what the runtime is compared with."""

    def __init__(self):
        self.holder, self.offered_to, self.is_on, self.is_stopped = "", "", False, False
        self.there, self.lapsed, self.watching = set(), set(), set()

    def do(self, deed, session, other):
        if deed not in ("silent", "leave"):
            self.there.add(session)
        if session in self.watching and deed not in ("silent", "leave", "stop", "watch"):
            return
        getattr(self, deed)(session, other)

    def give(self, session):
        if session != self.holder:
            self.holder, self.offered_to = session, ""

    def take(self, session, _other):
        if self.holder in ("", session) or self.offered_to == session:
            self.give(session)
            self.lapsed.discard(session)

    def release(self, session, _other):
        if self.holder == session:
            self.give("")

    def hand(self, session, other):
        able = other in self.there - self.watching - {session}
        if self.holder == session and session not in self.lapsed and able:
            self.offered_to = other

    def decline(self, session, _other):
        if self.offered_to == session:
            self.offered_to = ""

    def turn(self, session, _other):
        may = self.holder in ("", session) and session not in self.lapsed
        if may and (self.is_on or not self.is_stopped):
            self.give(session)
            self.is_on = not self.is_on

    def silent(self, session, _other):
        if self.holder == session:
            self.lapsed.add(session)
            self.give("")
            self.is_on = False

    def leave(self, session, _other):
        if self.holder == session:
            self.give("")
            self.is_on = False
        if self.offered_to == session:
            self.offered_to = ""
        self.there.discard(session)

    def watch(self, session, _other):
        if self.holder != session:
            self.watching.add(session)

    def stop(self, _session, _other):
        self.is_stopped, self.is_on = True, False

    def reset(self, session, _other):
        if self.holder in ("", session):
            self.is_stopped = False


def do(hand, deed, session, other):
    wishes = {
        "take": live.Take("s0"),
        "release": live.Release("s0"),
        "hand": holding.Hand("s0", other),
        "decline": holding.Decline("s0"),
        "watch": holding.OnlyWatch(),
        "stop": request.Stop(Reason.plain("enough")),
        "reset": live.Reset(),
    }
    if deed in wishes:
        hand.asker.ask(wishes[deed], session)
    elif deed == "turn":
        word = "off" if hand.states["counter"] == "ON" else "on"
        hand.change(**{word: ["counter"]}, session=session)
    elif deed == "silent":
        silent(hand, session, 1.5)
    else:
        leave(hand, session)


@settings(max_examples=examples(150), deadline=None)
@given(st.lists(DEEDS, min_size=3, max_size=20))
def test_there_are_never_two_writers_and_nothing_starts_by_itself(deeds):  # R-X12, network.md P4
    hand, rule = live_edits_with_tasks(), Rule()
    hand.asker.lease(SECOND)
    hand.change(spawn=["counter"], session="one")
    there(hand, *SESSIONS)
    rule.there.update(SESSIONS)
    rule.give("one")
    for number, (deed, session, other) in enumerate(deeds):
        do(hand, deed, session, other)
        rule.do(deed, session, other)
        standing = hand.asker.ask(live.Survey(), "witness").subsystems
        (hold,) = [
            (subsystem.holder, subsystem.tasks[0].state == "ON") for subsystem in standing if subsystem.name == "s0"
        ]
        assert hold == (rule.holder, rule.is_on), deeds[: number + 1]
        writers = {
            session
            for session in SESSIONS
            if not hand.asker.program.authority.refusal(session, live.Close("s0"), False)
        }
        assert not rule.holder or writers <= {rule.holder}
