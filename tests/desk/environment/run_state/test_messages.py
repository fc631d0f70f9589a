import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job, joints
from onika.words.reason import Reason

TRIGGER = (
    "MODULE a\nDESC a\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR A\nTASKTYPE periodic\nFREQ 10\n\n"
    "ONIKA\nOBJECT Joint job"
)


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def showing(icon, words):
    """An icon that shows these words."""
    return icon.replace("a job", words).replace("a target", words)


def move(where):
    return showing(job("aC", "Joint job"), "move the joints"), showing(joints("box", *[0.0] * 6), where)


def wording(play):
    return play.environment.model.run.wording


def test_an_action_is_called_by_what_its_icons_show_where_it_stands(play):  # R-E11
    play.files.task("a", TRIGGER)
    play.run(play.open([*move("above the box"), *move("into the box"), job("bC")]))
    play.began(0)
    assert play.view.flows["flow0"].action == "move the joints above the box"
    play.began(1)
    assert play.view.flows["flow0"].action == "move the joints into the box"


def test_actions_of_an_application_within_are_called_so_too(play):  # R-E06, R-D09
    play.files.task("a", TRIGGER)
    play.files.application("inner", [showing(job("bC"), "hold still")])
    play.run(play.open([showing(job("inner", "Complete application"), "wait a bit")]))
    play.began(0)
    flow = play.view.flows["flow0"]
    assert (flow.action, flow.within) == ("hold still", ("wait a bit",))


def test_a_text_names_no_file_and_no_line(play):  # R-E11, R-X06
    play.files.task("a", TRIGGER)
    play.run(play.open([*move("above the box"), showing(job("bC"), "hold still")]))
    plan = play.environment.model.run.plan.flows[0]
    first, second = plan.actions

    def shown(text):
        return str(wording(play).with_icons(Reason.plain(text)))

    assert shown(f"{first.place}:{first.line} (aC box): left by the user") == (
        "“move the joints above the box”: left by the user"
    )
    assert shown(f"{second.place}:{second.line} (bC): bC has no trigger") == "“hold still” has no trigger"
    assert shown(f"{second.place}:{second.line} (bC): b asks") == "“hold still”: b asks"
    assert shown(f"{second.place}:2: bC ends with b; a is a trigger too") == "play: bC ends with b; a is a trigger too"
    assert shown(f"{plan.tasks[0].place}: LOCAL N is no parameter") == "a: LOCAL N is no parameter"
    assert shown("rt0 is gone, see /var/log/x.log") == "rt0 is gone, see /var/log/x.log"


def test_choices_are_told_by_what_they_do_with_what_is_shown(play):  # R-E08
    play.run(play.open([showing(job("bC"), "hold still")]))
    with_icons = wording(play).with_icons
    clears = Reason.of("host.clears", tasks=("b",))
    repeats = Reason.of("host.and_repeats", what=clears, action="bC")
    assert str(with_icons(repeats)) == "clears b and repeats “hold still” with the same target"
    leaves = Reason.of("host.once_let_go", meaning=Reason.of("host.but_leaves", action="bC"))
    assert str(with_icons(leaves)) == (
        "once the panic button is let go: the same, but leaves “hold still” and goes on with what follows it"
    )
    ends = Reason.of("host.ends_the_run")
    assert with_icons(ends) is ends
