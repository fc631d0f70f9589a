from onika.desk.environment.state.target_values import checked, refusal_text, shown
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.store.site import open_site
from onika.wire.view import ItemView
from onika.words.reason import Reason

SYNTAX, _ = open_site([], {}, None).syntax()
PLACE = ItemView("place", "double", 3, "m", low=(0.0, 0.0, -1.0), high=(1.0, 1.0, 1.0))
TIMES = ItemView("times", "int", 1)
WORD = ItemView("word", "string", 1)
SIGN = ItemView("sign", "char", 1)


def test_values_are_shown_as_words_and_read_back():  # R-D08
    onikon = Onikon("there", "Joint object", "", ((0.0, -1.5, 1e-7, 2.0, 3.0, 0.1), (2.0,)), blank())
    words = shown(onikon, SYNTAX)
    assert words == (("0", "-1.5", "1e-07", "2", "3", "0.1"), ("2",))
    items = [ItemView("endpoint", "double", 6), ItemView("duration", "double", 1)]
    assert checked(items, words) == onikon.values
    assert shown(Onikon("odd", "Weld job", "", ((1,),), blank()), SYNTAX) == (("1",),)


def test_every_value_is_typed_and_within_its_bounds():  # R-D08
    assert checked([PLACE, TIMES, WORD, SIGN], (("0", " 1 ", "-1"), ("3",), ("two words",), (" ",))) == (
        (0.0, 1.0, -1.0),
        (3,),
        ("two words",),
        (" ",),
    )
    wrong = checked([PLACE, TIMES, WORD], (("2", "-0.5", ""), ("1.5",), ("two\nlines",)))
    assert {name: str(why) for name, why in wrong.items()} == {
        "place[0]": "2 is above 1 m",
        "place[1]": "-0.5 is below 0 m",
        "place[2]": "a value is missing: expected -1 to 1 m",
        "times": "expected a whole number (int), found '1.5'",
        "word": "expected text that fits on a line, found 'two\\nlines'",
    }
    assert str(refusal_text({"a": Reason.plain("b"), "c": Reason.plain("d")})) == "a: b; c: d"


def words_of(items, words):
    return {name: str(why) for name, why in checked(items, words).items()}


def test_there_are_as_many_values_as_the_type_has():  # R-D08
    assert words_of([TIMES], ()) == {"values": "expected times, found 0 values"}
    assert words_of([], (("1",),)) == {"values": "expected no values, found 1 values"}
    assert words_of([PLACE], (("1",),)) == {"place": "expected 3 values, found 1"}
    assert words_of([TIMES], (("",),)) == {"times": "a value is missing"}
    assert checked([], ()) == ()


def test_of_several_for_each_joint_there_are_so_many_for_every_one():  # R-D13, R-K08
    path = ItemView("coefficients", "double", 4, dimension="NDOF", each=2)
    assert checked([path], (("1", "2"),)) == ((1.0, 2.0),)
    assert words_of([path], (("1", "2", "3"),)) == {"coefficients": "expected 4 values, found 3"}
