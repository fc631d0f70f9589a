from onika.desk.environment.outcome.file_faults import told
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

LEFT_OUT = Reason.of("words.left_out")


def fault(file, number=0, instead=LEFT_OUT, *, is_note=False):
    return Fault(
        Place(f"/lab/boxes/{file}", number), Reason.plain("expected a `name`, found none"), instead, is_note=is_note
    )


def several(folder, count, **more):
    return [fault(f"{folder}/f{number}", **more) for number in range(count)]


def test_few_files_are_told_one_by_one():  # R-D15
    lines = told([*several("dict", 3), fault("dict/f1", 7), fault("dict/g", is_note=True)])
    assert [line.level for line in lines] == ["warning"] * 4 + ["info"]
    assert str(lines[0].text) == "/lab/boxes/dict/f0: expected a `name`, found none; instead: it is left out"


def test_many_files_that_a_dictionary_or_library_lists_are_one_line():  # R-D15, R-C01
    second = {"instead": Reason.of("words.first_used"), "is_note": True}
    lines = told([*several("dict", 12, **second), *several("module", 4)])
    assert [(line.level, str(line.text)) for line in lines] == [
        ("info", "12 files of boxes/dict are left out; the dictionary lists them"),
        ("warning", "4 files of boxes/module are left out; the library lists them"),
    ]


def test_what_is_read_and_odd_is_not_said_to_be_left_out():  # R-D15
    lines = told([*several("dict", 5, instead="it is read", is_note=True), fault("dict/bad")])
    assert [str(line.text).partition(";")[0] for line in lines] == [
        "5 files of boxes/dict are used and have something odd",
        "/lab/boxes/dict/bad: expected a `name`, found none",
    ]


def test_files_that_nobody_lists_are_all_told():
    assert len(told(several("appl", 9))) == 9
