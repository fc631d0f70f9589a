import pytest

from onika.files.conf import read, write
from onika.model.configuration import Configuration, Placed
from onika.model.own_lines import OwnLines
from onika.model.task import LocalLine

TEXT = """\
VERSION     2.0

RMODFILE    pd
AS          pd_left
COORDS      0 0
INLEFT      yes
FREQ        0
RTPU        unknown
SVARALIAS   Q_REF = Q_WISH
SVARALIAS   Q_MEZ = Q_MEZ
LOCAL       STIFF 0.5
LOCAL       NOTE
NOLOCAL     DAMP

EOF
"""
OWN = OwnLines(
    (("Q_REF", "Q_WISH"), ("Q_MEZ", "Q_MEZ")), (LocalLine("STIFF", ("0.5",)), LocalLine("NOTE", ())), ("DAMP",)
)
CONFIGURATION = Configuration("c", (Placed("pd_left", own=OWN, rmod="pd"),))


def reasons(text: str) -> list[str]:
    configuration, faults = read(text, "c", "f")
    assert configuration is None
    return [f"{fault.place.line}: {fault.reason.key}" for fault in faults]


def test_lines_of_a_placed_task_are_read_and_written() -> None:  # R-B09
    assert read(TEXT, "c", "f") == (CONFIGURATION, ())
    assert write(CONFIGURATION) == TEXT


def test_a_file_of_1_3_may_not_have_them() -> None:  # R-B06
    assert set(reasons(TEXT.replace("2.0", "1.3"))) == {
        f"{line}: files.version_for_line" for line in (4, 9, 10, 11, 12, 13)
    }


def test_a_configuration_without_them_is_one_of_1_3_again() -> None:  # R-B06
    assert write(Configuration("c", (Placed("pd"),)), TEXT).startswith("VERSION     1.3\n")


@pytest.mark.parametrize(
    ("line", "key"),
    [
        ("SVARALIAS Q_REF", "alias_line"),
        ("SVARALIAS Q_REF = Q_WISH\nSVARALIAS Q_REF = X", "one_alias"),
        ("SVARALIAS Q = = X", "alias_line"),
        ("LOCAL", "name_of_parameter"),
        ("LOCAL 7 x", "name_of_parameter"),
        ("LOCAL MODULE x", "name_of_parameter"),
        ("LOCAL A 1\nLOCAL A 2", "keyword_once"),
        ("LOCAL A 1\nNOLOCAL A", "keyword_once"),
        ("NOLOCAL A B", "name_of_parameter"),
    ],
)
def test_lines_that_say_nothing_or_two_things_are_faults(line: str, key: str) -> None:
    head = TEXT.partition("SVARALIAS")[0]
    assert [reason.partition("files.")[2] for reason in reasons(f"{head}{line}\nEOF\n")] == [key]


def test_a_name_stands_once_whatever_file_it_is_of() -> None:  # R-C07
    block = TEXT.partition("\n\n")[2].partition("SVARALIAS")[0]
    twice = f"VERSION 2.0\n{block}{block.replace('    pd', '    other', 1)}EOF\n"
    assert [reason.partition("files.")[2] for reason in reasons(twice)] == ["repeated_after"]


def test_one_file_stands_several_times_under_several_names() -> None:
    pair = Configuration("c", (Placed("pd"), Placed("pd_left", own=OWN, rmod="pd")))
    assert read(write(pair), "c", "f") == (pair, ())
