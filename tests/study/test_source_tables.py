from onika.study.source_tables import FOLDER


def test_the_tables_of_the_source_are_shipped():  # R-H03
    assert {path.name for path in FOLDER.iterdir()} == {"results.csv", "subjects.csv"}
