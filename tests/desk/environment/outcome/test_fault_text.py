import pytest

from onika.desk.environment.outcome.fault_text import said, together
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason, in_language

HERE = Place("play.appl", 3)
FLOW = Reason.of("rules.flow", number=2)
AT = Reason.of("rules.at", step=Reason.of("rules.icon", name="a"), position=3, flow=FLOW)
A = Reason.of("rules.icon_of_kind", name="a", kind="Number job")
B = Reason.of("rules.icon_of_kind", name="b", kind="Joint job")
PAIR = tuple(Reason.of("rules.task_in", name=name, configuration=f"{name}C", position=0) for name in "ab")


def waits(flow, tag, other):
    wait = Reason.of("rules.waits_at", tag=tag, place="play:7", action="putC", other=other)
    return Reason.of("rules.flow_waits", flow=flow, wait=wait)


CROSSED = Reason.of(
    "rules.wait_which", wait=waits("flow0", "A", "flow1"), further=waits("flow1", "B", "flow0").args["wait"]
)


@pytest.mark.parametrize(
    ("reason", "words"),
    [
        (
            Reason.of("rules.loop_tag_count", tag="l", flow=FLOW, count=1, at=AT),
            "the loop l is marked at one icon only",
        ),
        (Reason.of("rules.loop_tag_count", tag="l", flow=FLOW, count=3, at=AT), "the loop l is marked at 3 icons"),
        (
            Reason.of("rules.edges_unfit", left=A, right=B, position=1, flow=FLOW),
            "b (Joint job) does not fit behind a (Number job)",
        ),
        (Reason.of("rules.end_unfit", left=A, position=1, flow=FLOW), "nothing may end behind a"),
        (Reason.of("rules.target_missing", kind="Joint object", at=AT), "a wants a Joint target behind it"),
        (Reason.of("host.module_twice", module="led", other="lamp"), "its module led is used already, by lamp"),
        (Reason.of("rules.configuration_missing", name="aC", at=AT), "there is no configuration aC"),
        (Reason.of("rules.task_missing", name="pd", at=AT), "there is no task pd"),
        (Reason.of("rules.flow_empty", flow=FLOW), "flow 2 is empty"),
        (
            Reason.of("rules.tags_as_often_always", wait=waits("flow1", "A", "flow0"), when="when"),
            "flow1 could wait at the tag A in vain: flow0 does not come there as often",
        ),
        (
            Reason.of("rules.tags_in_order", wait=CROSSED),
            "flow0 waits at the tag A for flow1, which waits at the tag B for flow0: neither comes",
        ),
        (
            Reason.of("rules.kind_of_trigger", wanted="Joint job", trigger="jt", kind="Complete job", at=AT),
            "a is a Complete job here",
        ),
        (Reason.of("host.unreachable", target="far", why="joint 3 is beyond 3.93"), "far cannot be reached: joint 3"),
        (
            Reason.of("host.posture_missing", task="scara", old="puma", target="home", why="the hand leans"),
            "scara cannot come to home: the hand leans",
        ),
        (
            Reason.of("host.no_such_device", world="boxes", devices=("arm", "lamp"), device="boxes:bulb"),
            "there is no device boxes:bulb; boxes has arm, lamp",
        ),
        (
            Reason.of("host.no_world_of_device", worlds=("boxes",), device="shed:arm"),
            "there is no world for the device shed:arm, but boxes",
        ),
        (
            Reason.of("host.device_unlike", task="puma", device="b:x", why="expected y, found z"),
            "b:x is not the device that puma means: expected y",
        ),
        (Reason.of("host.device_claimed", device="b:arm", other="puma"), "puma and another task both claim b:arm"),
        (Reason.of("host.devices_unfit", world="boxes", why="'a' is kinematic"), "'a' is kinematic"),
        (
            Reason.of(
                "desk.substitute_unfit",
                old="a",
                reason=Reason.of("host.module_twice", module="m", other="b"),
            ),
            "its module m is used already, by b",
        ),
        (Reason.of("desk.task_not_of_flow", where="play", used=("a", "b"), old="puma"), "play does not use puma"),
        (Reason.of("runtime.constant_missing", svar="NDOF"), "no task gives the constant NDOF"),
        (
            Reason.of("rules.constant_missing", constant="NDOF", tasks=PAIR, flow=FLOW),
            "no task gives the constant NDOF",
        ),
        (
            Reason.of("runtime.port_undeclared", module="pd", kind="INVAR", name="ODD"),
            "module pd has no port INVAR ODD",
        ),
        (
            Reason.of(
                "runtime.port_unlike", kind="INVAR", name="Q", module="pd", given=Reason.of("runtime.no_such_port")
            ),
            "its task has no port INVAR Q, which module pd declares",
        ),
        (Reason.of("runtime.local_unfit", key="BASE", shape="double[4]", why="LOCAL BASE: few"), "LOCAL BASE: few"),
        (
            Reason.of("rules.hanging", svar="X", tasks=(Reason.of("rules.icon", name="b"),)),
            "nobody writes X, read by b",
        ),
        (Reason.of("host.values_unfit", task="jtraj", target="home", why="few"), "home does not suit jtraj: few"),
        (
            Reason.of("rules.condition_variable", subsystem="flow1", text="Q > 1", at=AT),
            "the condition Q > 1 asks",
        ),
    ],
    ids=lambda value: value.key if isinstance(value, Reason) else "",
)
def test_a_fault_is_told_without_line_and_step(reason, words):  # R-E01, R-X01
    for language in ("en", "es"):
        text = in_language(said(Fault(HERE, reason, NOT_RUN)), language)
        assert text.startswith(words) or language != "en"
        assert "step " not in text and "`" not in text and "branch" not in text


def test_what_has_no_words_of_its_own_says_what_was_expected_and_what_happens_instead():
    fault = Fault(HERE, Reason.plain("expected a sun, found rain"), Reason.plain("it is wet"), is_note=True)
    assert str(said(fault)) == "expected a sun, found rain; it is wet"


def test_what_two_tasks_have_in_common_is_told_once():  # law 9
    reasons = [Reason.of("rules.constant_twice", constants=(name,), tasks=PAIR, flow=FLOW) for name in ("DH", "KP")]
    faults = [Fault(HERE, reason, NOT_RUN) for reason in reasons]
    hole = Fault(HERE, Reason.of("rules.hole_open", at=AT), NOT_RUN)
    joined, other = together([faults[0], hole, faults[1]])
    assert str(said(joined)) == "a (in aC) and b (in bC) cannot live in one flow: both give DH, KP"
    assert other == hole
