import os

from onika.classroom.footprint import footprints

PAGE, TICKS = os.sysconf("SC_PAGE_SIZE"), os.sysconf("SC_CLK_TCK")


def put(proc, number, parent, pages, ticks, name="a b) c"):
    folder = proc / str(number)
    folder.mkdir()
    words = ["S", parent, 0, 0, 0, 0, 0, 0, 0, 0, 0, ticks, ticks, 0, 0, 0, 0, 0, 0, 0, 0, pages, 0]
    (folder / "stat").write_text(f"{number} ({name}) {' '.join(map(str, words))}\n")


def test_a_family_is_counted_with_all_that_it_has_started(tmp_path):  # R-X25
    for number, parent, pages in ((1, 0, 100), (10, 1, 7), (11, 10, 5), (12, 11, 3), (20, 1, 9)):
        put(tmp_path, number, parent, pages, TICKS)
    (tmp_path / "self").mkdir()
    costs = footprints((10, 20, 99), tmp_path)
    assert costs[10].bytes == 15 * PAGE
    assert costs[10].processor_s == 6.0
    assert costs[10].processes == (10, 11, 12)
    assert costs[20].processes == (20,)
    assert costs[99].processes == ()


def test_what_ends_meanwhile_or_makes_no_sense_is_passed_over(tmp_path):
    put(tmp_path, 10, 1, 1, 0)
    (tmp_path / "11").mkdir()
    (tmp_path / "11" / "stat").write_text("nonsense")
    assert footprints((10, 11), tmp_path)[10].processes == (10,)


def test_this_very_process_costs_something():
    assert footprints((os.getpid(),))[os.getpid()].bytes > 1 << 20
