"""The folder of a study: what is in it is read, what is wrong with it is named."""

import pytest

from kit.study.log_text import assembly
from onika.study import folder
from onika.study.source_tables import FOLDER


def keys(study):
    return [(str(fault.place), fault.reason.key) for fault in study.faults]


@pytest.mark.parametrize(
    "foreign",
    [
        lambda text: text.replace("\n", "\r\n").encode(),
        lambda text: text.replace("\n", "\r").encode(),
        lambda text: b"\xef\xbb\xbf" + text.encode(),
        lambda text: text.encode("utf-16"),
        lambda text: text.replace("\t", "    ").encode(),
        lambda text: text.replace(".", ",").encode(),
        lambda text: "".join(f"  {line}  \n" for line in text.splitlines()).encode(),
    ],
)
def test_a_log_as_other_systems_write_it_is_the_same_log(tmp_path, foreign):  # R-H02
    (tmp_path / "a.log").write_text(assembly(4.0))
    (tmp_path / "b.log").write_bytes(foreign(assembly(4.0)))
    study = folder.read(tmp_path)
    ours, other = study.subjects
    assert study.faults == ()
    assert (other.figures, other.selections) == (ours.figures, ours.selections)


def test_a_log_of_nothing_is_named_and_not_counted(tmp_path):  # R-H02
    (tmp_path / "a.log").write_bytes(b"")
    (tmp_path / "b.log").write_text("no log at all\n")
    study = folder.read(tmp_path)
    assert [subject.is_compared for subject in study.subjects] == [False, False]
    told = [(fault.place.file, fault.reason.key) for fault in study.faults]
    assert ("a.log", "study.empty_log") in told
    assert {("b.log", "study.columns"), ("b.log", "study.empty_log")} <= {*told}


def test_logs_lie_in_the_folder_in_logs_and_in_folders_of_subjects(tmp_path):  # R-H02
    (tmp_path / "logs" / "p10").mkdir(parents=True)
    for path in ("p2.log", "logs/p1.raw", "logs/p10/a.log", ".hidden.log", "notes.txt"):
        (tmp_path / path).write_text(assembly(4.0))
    study = folder.read(tmp_path)
    assert [subject.name for subject in study.subjects] == ["p1", "p2", "p10"]
    assert study.faults == ()
    assert {subject.group for subject in study.subjects} == {"all"}


def test_groups_and_who_is_removed_stand_in_a_table(tmp_path):  # R-H02
    for name in ("p1", "p2", "p4"):
        (tmp_path / f"{name}.log").write_text(assembly(4.0))
    (tmp_path / "subjects.csv").write_text("subject,group,removed\np1,both,\np2,words,was called away\np3,words,\n")
    study = folder.read(tmp_path)
    assert [(subject.name, subject.group, subject.is_compared) for subject in study.subjects] == [
        ("p1", "both", True),
        ("p2", "words", False),
        ("p4", "all", True),
    ]
    assert keys(study) == [("subjects.csv", "study.not_listed"), ("subjects.csv:4", "study.no_log")]


def test_all_who_have_no_log_yet_are_told_together(tmp_path):  # R-H02
    (tmp_path / "s01.log").write_text(assembly(4.0))
    (tmp_path / "subjects.csv").write_text("subject,group\ns01,both\ns02,words\ns03,both\n")
    (fault,) = folder.read(tmp_path).faults
    assert (fault.place.line, str(fault.reason)) == (3, "without log and results: s02 and s03")


def test_two_logs_of_one_name_are_both_left_out(tmp_path):  # R-H02
    (tmp_path / "p1").mkdir()
    for path in ("p1.log", "p1.raw", "p1/a.log", "p2.log"):
        (tmp_path / path).write_text(assembly(4.0))
    study = folder.read(tmp_path)
    assert [subject.name for subject in study.subjects] == ["p2"]
    assert keys(study) == [("p1/a.log, p1.log, p1.raw", "study.logs_of_one_name")]


def test_a_log_and_a_row_of_results_are_not_counted_twice(tmp_path):  # R-H02
    (tmp_path / "p1.log").write_text(assembly(4.0))
    (tmp_path / "results.csv").write_text("subject,group,mean_selection_s\np1,both,9\np2,both,5\n")
    study = folder.read(tmp_path)
    assert [subject.figures["mean_selection_s"] for subject in study.subjects] == [4.0, 5.0]
    assert keys(study) == [("results.csv:2", "study.has_log")]


def test_a_log_that_is_no_text_is_read_as_far_as_it_goes_and_its_subject_marked(tmp_path):  # R-H02
    (tmp_path / "p1.log").write_bytes(assembly(4.0).encode().replace(b"Untitled-1", b"Untitl\xe9-1"))
    (tmp_path / "p2.log").write_bytes(assembly(4.0).encode())
    (tmp_path / "p3.log").write_bytes(b"\0\1\2\3" * 100)
    study = folder.read(tmp_path)
    assert [subject.is_doubtful for subject in study.subjects] == [True, False, True]
    assert study.subjects[0].figures == study.subjects[1].figures
    assert ("p1.log:3", "files.not_utf8") in keys(study)
    assert ("p3.log:1", "study.columns") in keys(study)
    assert not study.subjects[2].is_compared


def test_answers_are_read(tmp_path):  # R-H05
    answers = ",".join(f"sus{number}" for number in range(1, 11))
    (tmp_path / "questionnaires.csv").write_text(f"subject,{answers}\np1,5,1,5,1,5,1,5,1,5,1\n")
    (given,) = folder.read(tmp_path).answers
    assert (given.subject, given.sus) == ("p1", 100)


def test_an_empty_folder_is_a_study_of_nobody(tmp_path):  # R-H02
    assert folder.read(tmp_path).subjects == ()


def test_the_tables_of_the_source_are_read_without_fault():  # R-H03
    study = folder.read(FOLDER)
    assert study.faults == ()
    assert [subject.name for subject in study.subjects if not subject.is_compared] == ["p2", "t1"]
    assert len(study.subjects) == 23
    assert "pt9" not in {subject.name for subject in study.subjects}


def test_names_are_in_the_order_in_which_people_count():
    names = ["p10", "p2", "t1", "p1b", "p1"]
    assert sorted(names, key=folder.natural) == ["p1", "p1b", "p2", "p10", "t1"]


def test_a_subject_that_stands_twice_in_the_table_is_not_counted_although_there_is_a_log(tmp_path):  # R-H02
    for name in ("p1", "p2"):
        (tmp_path / f"{name}.log").write_text(assembly(4.0))
    (tmp_path / "subjects.csv").write_text("subject,group\np1,both\np2,words\np1,words\n")
    study = folder.read(tmp_path)
    assert [(subject.name, subject.group) for subject in study.subjects] == [("p2", "words")]
    assert keys(study) == [("subjects.csv:4", "study.subject_twice")]
