"""What a law says is English text that has its key and its arguments with it, also in an exception."""

from onika.laws.sentence import LawSentence, joint_beyond, no_element, sentence_of
from onika.words.reason import Reason, in_language, reason_of

LEANS = LawSentence("laws.hand_leans", "the hand would lean {lean:.0f} degrees", lean=92.4)


def test_a_sentence_is_its_english_text():
    assert LEANS == "the hand would lean 92 degrees" and str(ValueError(LEANS)) == LEANS
    assert (LEANS.key, LEANS.arguments) == ("laws.hand_leans", {"lean": 92.4})


def test_an_exception_gives_back_the_sentence_that_it_was_raised_with():
    assert sentence_of(ValueError(LEANS)) is LEANS
    assert [sentence_of(ValueError("too few values")), sentence_of(ValueError())] == ["too few values", ""]


def test_a_sentence_of_a_law_becomes_a_reason_without_that_either_knows_the_other():
    reason = reason_of(ValueError(joint_beyond(3, 4.4, "rad", -2.5, 3.926)))
    assert reason == Reason.of("laws.joint_beyond", joint=3, value=4.4, unit="rad", low=-2.5, high=3.926)
    assert in_language(reason, "es") == "la articulación 3 quedaría a 4,400 rad, fuera de -2,500..3,926"


def test_an_element_is_counted_from_0():
    assert [no_element("ELEMENT", number, 2) for number in (0, 1)] == [None, None]
    assert [no_element("ELEMENT", number, 2) for number in (2, -1)] == [
        "ELEMENT: expected 0..1, found 2",
        "ELEMENT: expected 0..1, found -1",
    ]
