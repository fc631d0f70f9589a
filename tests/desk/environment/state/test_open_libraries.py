from dataclasses import replace

from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.library import open_libraries

A = Task("a", "a", outvar=("Q",), frequency=1.0)


def libraries(tmp_path):
    for folder, task in (("one", A), ("two", replace(A, description="the other"))):
        BaseDirectory(tmp_path / folder).save_task(RmodText(task))
    return OpenLibraries(open_libraries(BaseDirectory(tmp_path / folder) for folder in ("one", "two")))


def test_the_first_library_with_a_name_counts(tmp_path):  # R-C01
    opened = libraries(tmp_path)
    assert opened.tasks["a"].description == ""
    assert opened.homes["a"].base.path.name == "one"


def test_an_edit_stands_for_the_file_until_it_says_the_same(tmp_path):  # R-C04
    changed = replace(A, aliases=(("Q", "R"),))
    edited = libraries(tmp_path).edited({"a": changed})
    assert edited.tasks["a"].outputs == {"R"}
    assert edited.edited({"a": None}).edits == {}
    assert edited.edited({"a": edited.records["a"].task}).edits == {}


def test_boxes_follow_the_edits(tmp_path):
    edited = libraries(tmp_path).edited({"a": replace(A, aliases=(("Q", "R"),))})
    assert edited.box("a").pins[0].svar == "R"
    assert edited.box("nobody") is None
    assert list(edited.boxes(("a", "nobody"))) == ["a"]


def test_an_edit_changes_what_a_user_can_change_and_the_rest_is_as_the_file_says(tmp_path):  # R-C04
    opened = libraries(tmp_path)
    stale = replace(A, description="old", aliases=(("Q", "R"), ("GONE", "S")))
    assert opened.edited({"a": stale}).tasks["a"] == replace(A, aliases=(("Q", "R"),))


def test_what_is_known_of_the_files_is_known_after_an_edit_and_nothing_of_the_edited(tmp_path):  # R-C04
    opened = libraries(tmp_path)
    assert opened.box("a") and opened.company
    edited = opened.edited({"a": replace(A, aliases=(("Q", "R"),))})
    assert edited.records is opened.records
    tasks, box = edited.tasks, edited.box("a")
    rated = edited.rated({"a": 5.0})
    assert rated.tasks is tasks
    assert rated.box("a") is box
    assert rated.rates == {"a": 5.0}
    assert rated.rated({"a": None}).rates == {}
    meets = [task.name for task, _ in edited.company.kept_out_by(Task("b", "b", outvar=("R",)))]
    assert meets == ["a"]


def test_code_is_found_beside_the_task_first(tmp_path):  # R-C05, R-C23
    assert libraries(tmp_path).code_file("a") is None
    for folder in ("two", "one"):
        (tmp_path / folder / "module" / "a.py").write_text("")
        assert libraries(tmp_path).code_file("a") == tmp_path / folder / "module" / "a.py"
