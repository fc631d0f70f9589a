"""`onika study design`, as a user enters it."""

import pytest

from onika.cli import main
from onika.study import table

WORDS = ["study", "design", "--variants", "pictures,both,words", "--subjects", "24", "--seed", "7"]


def test_the_table_is_printed_and_can_be_read_as_that_of_a_study(capsys):  # R-H03
    assert main(WORDS) == 0
    rows, faults = table.read(capsys.readouterr().out, "subjects.csv")
    assert faults == ()
    assert len(rows) == 24
    assert {row.cells["group"] for row in rows} == {"pictures", "both", "words"}


def test_a_file_that_is_there_is_left_alone(tmp_path, capsys):  # R-H03
    path = tmp_path / "subjects.csv"
    assert main([*WORDS, "-o", str(path)]) == 0
    before = path.read_text()
    assert main([*WORDS[:-1], "8", "-o", str(path)]) == 2
    assert path.read_text() == before
    assert "subjects.csv" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("option", "value"),
    [
        *(("--variants", value) for value in ("a", "a,a", "a,")),
        *(("--subjects", value) for value in ("0", "2", "many")),
        *(("--seed", value) for value in ("-1", "99999999999999")),
    ],
)
def test_a_wrong_word_is_refused(option, value, capsys):  # R-H03
    with pytest.raises(SystemExit) as ended:
        main([*WORDS, f"{option}={value}"])
    assert ended.value.code == 2
    assert capsys.readouterr().out == ""
