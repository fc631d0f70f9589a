"""Files of a folder are chosen, copied and listed: a laboratory without any robot."""

import os

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "folders" / "module"
DAY_S = 86_400


@pytest.fixture
def folder(tmp_path):
    """Two equal pictures, an old one, a text, a hidden file and a folder."""
    place = tmp_path / "from"
    place.mkdir()
    for name, content in {"a.jpg": b"one", "b.jpg": b"one", "old.PNG": b"two", "ñ.txt": b"a text", ".x": b"x"}.items():
        (place / name).write_bytes(content)
    (place / "within").mkdir()
    long_ago = (place / "a.jpg").stat().st_mtime - 400 * DAY_S
    os.utime(place / "old.PNG", (long_ago, long_ago))
    return place


def written(*names):
    """Names as they stand in the variable."""
    memory = np.zeros(65_536, np.uint8)
    text = os.fsencode("".join(f"{name}/" for name in names))
    memory[: len(text)] = np.frombuffer(text, np.uint8)
    return memory


def read(memory):
    return os.fsdecode(bytes(memory).rstrip(b"\0")).split("/")[:-1]


def bench_of(module, folder=None, names=()):
    bench = Bench(MODULES / f"{module}.py", frequency=20).init()
    if folder is not None:
        bench["FOLDER"], bench["FILES"] = str(folder), written(*names)
    return bench


def to_its_end(bench, most=1000):
    while bench.state is State.ON and bench.cycles < most:
        bench.cycle()
    return bench


def only(folder, which, names=("a.jpg", "b.jpg", "old.PNG", "ñ.txt")):
    bench = to_its_end(bench_of("only_files", folder, names).on(f'"{which}"'))
    return read(bench["NEXT_FILES"]), (bench.finished.flow, bench.finished.loop)


def test_a_folder_is_opened_with_all_its_files_but_hidden_ones(folder):  # R-K10
    bench = to_its_end(bench_of("open_folder").on(str(folder)))
    assert read(bench["NEXT_FILES"]) == ["a.jpg", "b.jpg", "old.PNG", "ñ.txt"]
    assert bench["NEXT_FOLDER"] == str(folder)
    assert (bench.finished.flow, bench.finished.loop) == (0, False)


def test_what_is_chosen_stays_from_job_to_job(folder):  # R-K10
    bench = Bench(MODULES / "chosen_files.py", frequency=20).init()
    bench["NEXT_FOLDER"], bench["NEXT_FILES"] = str(folder), written("a.jpg", "ñ.txt")
    bench.on()
    assert (bench["FOLDER"], read(bench["FILES"]), bench["COUNT"]) == (str(folder), ["a.jpg", "ñ.txt"], 2)


@pytest.mark.parametrize(
    ("which", "remaining"),
    [
        ("*.jpg *.png", ["a.jpg", "b.jpg", "old.PNG"]),
        ("newer 30", ["a.jpg", "b.jpg", "ñ.txt"]),
        ("older 30", ["old.PNG"]),
        ("larger 0.000004", ["ñ.txt"]),
        ("twins", ["a.jpg", "b.jpg"]),
    ],
)
def test_files_are_left_by_name_age_size_and_content(folder, which, remaining):  # R-K10
    assert only(folder, which) == (remaining, (1, True))


def test_where_none_is_left_another_flow_is_taken(folder):  # R-K10, R-E05
    assert only(folder, "larger 5") == ([], (0, False))


@pytest.mark.parametrize("which", ["", "newer", "newer much", "older 1 2", "nothing of the kind"])
def test_a_choice_that_is_not_understood_is_asked_for_anew(folder, which):  # R-K10
    bench = bench_of("only_files", folder, ["a.jpg"]).on(f'"{which}"')
    assert bench.state is State.ASKING
    assert bench.answer("twins").state is State.ON


def test_a_chosen_file_that_is_gone_is_an_error(folder):  # R-K10
    bench = to_its_end(bench_of("only_files", folder, ["gone.jpg"]).on('"newer 3"'))
    assert bench.state is State.ERROR
    assert "gone.jpg" in bench.failed.text


def test_copies_keep_their_dates_and_nothing_is_written_over(folder, tmp_path):  # R-K10, R-B07
    target = tmp_path / "to" / "there"
    target.mkdir(parents=True)
    (target / "b.jpg").write_bytes(b"mine")
    for _ in range(2):  # the second time all is there already
        bench = to_its_end(bench_of("copy_files", folder, ["a.jpg", "b.jpg", "old.PNG"]).on(str(target)))
        assert (bench.finished.flow, bench["COPIED"]) == (0, 3)
    contents = {path.name: path.read_bytes() for path in target.iterdir()}
    assert contents == {"a.jpg": b"one", "b.jpg": b"mine", "b 2.jpg": b"one", "old.PNG": b"two"}
    assert (target / "old.PNG").stat().st_mtime == (folder / "old.PNG").stat().st_mtime


def test_a_copy_that_is_broken_off_leaves_nothing_half_made(folder, tmp_path):  # R-B07
    (folder / "long.bin").write_bytes(bytes(10_000_000))
    bench = bench_of("copy_files", folder, ["long.bin"]).on(str(tmp_path / "to"))
    bench.cycle()
    assert [path.name for path in (tmp_path / "to").iterdir()] == [".long.bin.part"]
    bench.off()
    assert list((tmp_path / "to").iterdir()) == []


@pytest.mark.parametrize(("module", "file"), [("open_folder", False), ("copy_files", False), ("list_files", True)])
def test_paths_begin_at_the_root_or_at_home(folder, tmp_path, module, file):  # R-K10
    bench = bench_of(module) if module == "open_folder" else bench_of(module, folder, ["a.jpg"])
    assert bench.on("somewhere").state is State.ASKING
    assert bench.answer(f"{tmp_path}{'/t.csv' if file else ''}").state is State.ON


def test_files_are_not_copied_onto_themselves(folder):  # R-K10
    assert bench_of("copy_files", folder, ["a.jpg"]).on(f"{folder}/../from").state is State.ASKING


def test_a_table_has_a_row_for_each_chosen_file(folder, tmp_path):  # R-K10
    table = tmp_path / "table.csv"
    bench = to_its_end(bench_of("list_files", folder, ["a.jpg", "ñ.txt"]).on(str(table)))
    rows = table.read_text(encoding="utf-8").splitlines()
    assert bench.finished.flow == 0
    assert [row.split(",")[:2] for row in rows] == [["name", "bytes"], ["a.jpg", "3"], ["ñ.txt", "6"]]


def test_a_table_that_cannot_be_written_leaves_the_old_one(folder, tmp_path):  # R-B07
    table = tmp_path / "table.csv"
    table.write_text("old")
    assert to_its_end(bench_of("list_files", folder, ["gone"]).on(str(table))).state is State.ERROR
    assert (table.read_text(), list(tmp_path.glob(".*"))) == ("old", [])
