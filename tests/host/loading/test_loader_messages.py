import pytest

from onika.host.loading import loader_messages as room
from onika.host.loading.loader import decode_answer, decode_question, encode
from onika.wire.plan import Code
from onika.wire.request import FaultText
from onika.words.reason import Reason

CODE = Code("digest", "arm", "arm.py", "# arm")


@pytest.mark.parametrize(
    "question",
    [
        room.AskSheet(CODE),
        room.AskConstants(CODE, (("BASE", ("0", "1")),)),
        room.AskReach(CODE, {"N": 2}, [("joint object", [0.1, 2])]),
        room.AskPoses(CODE, {"N": 2}, [[0.1, 0.2]]),
        room.AskPostures(CODE, {"N": 2}, [[0.0] * 9]),
        room.AskFit(CODE, {"N": 2}, "w:d"),
        room.AskCompany("w", ("d", "e")),
        room.AskDevices("w"),
    ],
)
def test_every_question_arrives_as_it_was_asked(question):  # law 21
    assert decode_question(encode(question)) == question


@pytest.mark.parametrize(
    "sentence",
    [
        room.Constants({"N": 2}),
        room.Reach([None, Reason.plain("too far")]),
        room.KnownPoses([[0.5] * 9]),
        room.KnownPoses(None),
        room.Postures([[0.1], Reason.plain("too far")]),
        room.Objections((Reason.plain("another robot"),)),
        room.Devices(("d",)),
        room.UnusableModule(
            FaultText(
                "a.py",
                3,
                Reason.plain("expected one, found two"),
                Reason.plain("three"),
                Reason.plain("flow0"),
                (Reason.plain("mend it"),),
            )
        ),
    ],
)
def test_every_answer_arrives_as_it_was_given(sentence):  # law 21
    assert decode_answer(encode(sentence)) == sentence
