import csv
import io

from onika.study import folder
from onika.study.compared import compared
from onika.study.report.figure_files import files
from onika.study.source_tables import FOLDER


def rows(text):
    return [*csv.DictReader(io.StringIO(text))]


def test_the_figures_of_the_source_are_in_the_tables():  # R-H03
    study = folder.read(FOLDER)
    tables = files(study, compared(study.subjects))
    anova = next(row for row in rows(tables["tests.csv"]) if row["test"] == "anova")
    assert (anova["figure"], round(100 * float(anova["p"]), 2)) == ("mean_selection_s", 6.99)
    pair = rows(tables["pairs.csv"])[1]
    assert (pair["first"], pair["second"], round(float(pair["high"]), 4)) == ("both", "words", 0.0907)
    assert [row["compared"] for row in rows(tables["figures.csv"])].count("no") == 2


def test_timelines_have_the_time_since_the_event_before(study):  # R-H02
    tables = files(study, compared(study.subjects))
    first = [row for row in rows(tables["timelines.csv"]) if row["subject"] == "b1"]
    assert [(row["event"], row["after_s"], row["at_s"]) for row in first[:3]] == [
        ("new_appl", "0", "0"),
        ("select_icon", "3", "3"),
        ("insert_icon", "2", "5"),
    ]
    assert len(rows(tables["selections.csv"])) == 7 * 12
    assert [row["sus"] for row in rows(tables["scores.csv"])] == ["100", "50"]
    assert {row["is_first_try"] for row in rows(tables["figures.csv"])} == {"yes"}
