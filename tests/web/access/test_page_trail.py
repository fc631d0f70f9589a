from onika.link.caller import Role
from onika.web.access.entrance import Visitor
from onika.web.access.page_trail import PageTrail
from onika.wire import act
from onika.words.reason import NOTHING, Reason

ANN = Visitor("ann", Role.OPERATOR, "s1", "10.0.0.1")


class Lines:
    def __init__(self):
        self.lines = []
        self.trouble = NOTHING

    def note(self, what, weighs=False, **about):
        self.lines.append((what, {key: value for key, value in about.items() if value}))


def lines(do):
    written = Lines()
    do(PageTrail(written))
    return written.lines


def test_each_entry_and_each_that_is_refused_has_a_line():  # R-F10, R-X12
    def do(trail):
        trail.entered(ANN)
        trail.turned_away("ann", "10.0.0.2", "wrong-password")
        trail.turned_away("", "10.0.0.2", "wrong-password")
        trail.left(ANN, "signed-out")

    assert lines(do) == [
        ("SignIn", {"who": "ann", "role": "operator", "address": "10.0.0.1", "result": "done"}),
        ("SignIn", {"who": "ann", "address": "10.0.0.2", "result": "refused:wrong-password"}),
        ("SignIn", {"who": "?", "address": "10.0.0.2", "result": "refused:wrong-password"}),
        ("SignOut", {"who": "ann", "role": "operator", "address": "10.0.0.1", "result": "signed-out"}),
    ]


def test_what_is_done_has_a_line_and_looking_has_none():  # R-X12
    def do(trail):
        for command in (act.Watch(("a/Q",)), act.Scene("boxes"), act.Note("select"), act.SampleVariables(("a/Q",))):
            trail.acted(ANN, command, NOTHING)
        trail.acted(ANN, act.Turn("c1", ("pd", "robot"), True), NOTHING)
        trail.acted(ANN, act.Stop(), Reason.of("run.not_linked"))

    told = [(what, about.get("about"), about["result"]) for what, about in lines(do)]
    assert told == [("Turn", "doc=c1 tasks=pd,robot", "done"), ("Stop", None, "refused:run.not_linked")]


def test_no_secret_and_no_text_gets_there():  # R-F10
    def do(trail):
        trail.acted(ANN, act.Connect("c1", "wss://ann:secret@x", "secret"), NOTHING)
        trail.acted(ANN, act.BrowseLibrary("https://x", "ann", "secret"), NOTHING)
        trail.acted(ANN, act.Answer("c1", "t", "secret"), NOTHING)
        trail.acted(ANN, act.WriteText("t", "code", "secret", "s"), NOTHING)

    assert len(lines(do)) == 4
    assert "secret" not in str(lines(do))


def test_of_the_pushes_of_a_pad_only_the_first_and_the_last_have_a_line():
    axes = (0.0,) * 6

    def do(trail):
        for is_held in (False, True, True, True, False, False):
            trail.acted(ANN, act.Push(axes, is_held), NOTHING)

    assert len(lines(do)) == 2


def test_what_a_role_may_not_has_a_line():  # R-F10
    def do(trail):
        trail.denied(ANN, act.Save("c1"))
        trail.denied(ANN, act.Note("select"))

    assert [(what, about["result"]) for what, about in lines(do)] == [("Save", "refused:role")]


def test_that_nothing_can_be_written_is_told_once():
    written, told = Lines(), []
    trail = PageTrail(written, told.append)
    written.trouble = Reason.plain("the disk is full")
    trail.entered(ANN)
    trail.entered(ANN)
    assert told == [written.trouble]
