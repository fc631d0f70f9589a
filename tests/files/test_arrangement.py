from onika.files import arrangement

TEXT = """VERSION     2.0

PLACE       home
PLACE       above

BASE        puma
PLACE       pd
PLACE       diff

EOF
"""


def read(text):
    return arrangement.read(text, "a", "f")


def test_names_stand_in_their_order_those_of_shipped_directories_apart():  # R-D24, R-B09
    assert read(TEXT) == ({"": ("home", "above"), "puma": ("pd", "diff")}, ())
    assert arrangement.write({"puma": ("pd", "diff"), "": ("home", "above")}) == TEXT


def test_what_is_empty_is_not_written():  # R-D24
    assert arrangement.write({"": (), "puma": ()}) == "VERSION     2.0\n\nEOF\n"
    assert read("VERSION     2.0\n\nEOF\n") == ({}, ())


def test_a_name_twice_and_what_is_no_name_are_told_and_the_usual_order_is_kept():  # R-B07
    for line in ("PLACE       home", "PLACE       ../up", "BASE        puma\nPLACE       x", "FLIP        x"):
        value, faults = read(TEXT.replace("EOF", f"{line}\n\nEOF").replace("PLACE       pd\n", "PLACE       home\n", 1))
        assert value is None or line == "PLACE       home"
        assert faults or line == "PLACE       home"
    value, (fault,) = read(TEXT.replace("above", "home"))
    assert (value, fault.place.line, str(fault.instead)) == (None, 4, "the usual order is kept")


def test_the_comments_of_a_former_text_stay():  # R-B01
    commented = TEXT.replace("PLACE       above", "# the shelf\nPLACE       above")
    assert "# the shelf" in arrangement.write({"": ("above", "home")}, commented)


def test_a_file_of_version_1_3_has_no_such_lines_of_another_time():  # R-B06
    assert read(TEXT.replace("2.0", "3.0"))[0] is None
