"""Types in sentences: what files call objects are targets, with the article that suits them."""

from onika.desk.environment.outcome.kind_text import kind_or_kinds, kind_text, with_article
from onika.words.reason import in_language


def test_an_object_is_a_target_in_every_language():
    kind = kind_text("Joint object")
    assert str(kind) == "Joint target"
    assert in_language(with_article(kind), "es") == "un objetivo Joint"


def test_another_type_is_called_as_it_is():
    assert str(with_article(kind_text("Complete job"))) == "a Complete job"
    assert str(with_article(kind_text("Arm job"))) == "an Arm job"


def test_several_types_are_joined_before_the_last():
    assert str(kind_or_kinds(("Joint object", "Tool object"))) == "Joint target and Tool target"
