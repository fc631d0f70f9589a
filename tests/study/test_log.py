"""What can be read of a log is read; what cannot is named with its line."""

from hypothesis import given, strategies as st

from kit.study.log_text import LogText, assembly, with_records
from onika.study import log as logs


def reasons(faults):
    return [(fault.place.line, fault.reason.key) for fault in faults]


def test_a_log_of_the_diary_is_read_whole():  # R-H02
    log, faults = logs.read(assembly(4.0), "p1.log")
    assert faults == ()
    assert log.entries[0].event == "Start_Onika"
    assert log.entries[2].event == "select_icon"
    assert log.entries[2].line == 4
    assert not log.is_in_seconds
    assert [*logs.doubts([log])] == []


def test_a_log_of_the_thesis_is_read_with_blanks_between_columns_too():  # R-H02
    log, faults = logs.read("Time Event Primary\n770909690 select_icon opengripC 3496920 none 0 dict\n", "pt3.raw")
    assert faults == ()
    assert log.is_in_seconds
    (entry,) = log.entries
    assert (entry.at_s, entry.object, entry.id, entry.window) == (770909690.0, "opengripC", "3496920", "dict")


def test_a_line_that_is_cut_is_left_out_and_named():  # R-H02
    text = assembly(4.0)
    cut = text[: text.rindex("\t")]
    log, faults = logs.read(cut, "p1.log")
    assert reasons(faults) == [(cut.count("\n") + 1, "study.columns")]
    assert [fault.reason.key for fault in logs.doubts([log])] == ["study.no_end"]


def test_an_edited_time_leaves_out_that_line_and_no_other():  # R-H02
    lines = assembly(4.0).split("\n")
    for change in ("999999999.000", "1890000000.000"):  # long before, long after
        edited = [*lines]
        edited[6] = change + edited[6][edited[6].index("\t") :]
        log, faults = logs.read("\n".join(edited), "p1.log")
        assert reasons(faults) == [(7, "study.time_goes_back")]
        assert len(log.entries) == len(lines) - 3


def test_no_time_is_a_fault():  # R-H02
    for word in ("noon", "nan", "inf", "-5", "1e300"):
        log, faults = logs.read(f"{word}\tnew_appl\ta\tb\tnone\t0\tappl\n", "p1.log")
        assert reasons(faults) == [(1, "study.no_time")]
        assert log.entries == ()


def test_of_very_many_wrong_lines_the_first_are_named_and_the_rest_counted():  # R-H02
    _, faults = logs.read("garbage\n" * 5000, "p1.log")
    assert len(faults) == 11
    assert faults[-1].reason.args["count"] == 4990
    assert faults[-1].place.line == 11


def test_a_second_session_in_a_log_is_told():  # R-H02
    first, second = assembly(4.0), LogText(1_790_009_000.0).start().new().quit().text
    log, faults = logs.read(first + second, "p1.log")
    assert faults == ()
    (doubt,) = logs.doubts([log])
    assert doubt.reason.key == "study.second_session"
    assert doubt.is_note


def test_two_logs_mixed_line_by_line_are_noticed():  # R-H02
    ours, other = assembly(4.0).splitlines(), assembly(6.0, begin_s=1_790_000_003.0).splitlines()
    mixed = [line for pair in zip(ours, other, strict=True) for line in pair]
    log, faults = logs.read("\n".join(mixed), "p1.log")
    assert {fault.reason.key for fault in (*faults, *logs.doubts([log]))} >= {
        "study.time_goes_back",
        "study.second_session",
    }


@given(st.text(max_size=300))
def test_any_text_is_read_without_a_crash_and_in_order(text):  # R-H02
    log, _ = logs.read(text, "x")
    times = [entry.at_s for entry in log.entries]
    assert times == sorted(times)


@given(st.lists(st.integers(0, 9), min_size=1, max_size=8))
def test_the_fewest_lines_are_left_out(times):
    """Compared with all subsets."""
    text = "".join(f"{time}\te\to\t0\tnone\t0\troot\n" for time in times)
    log, _ = logs.read(text, "x")
    subsets = ([t for i, t in enumerate(times) if mask >> i & 1] for mask in range(1 << len(times)))
    longest = max(len(row) for row in subsets if row == sorted(row))
    assert len(log.entries) == longest


def test_a_log_with_records_comes_to_the_same():  # R-H02
    plain, _ = logs.read(assembly(4.0), "p1.log")
    log, faults = logs.read(with_records(assembly(4.0)), "p1.log")
    assert faults == ()
    assert log == plain


def test_of_a_log_with_records_a_changed_line_a_lost_line_and_one_of_another_are_named():  # R-H02
    lines = with_records(assembly(4.0)).splitlines()
    other = with_records(assembly(4.0), "0bad").splitlines()
    lines[5] = lines[5].replace("box2_aj", "jmoveC").replace("jmoveC", "box3_aj")
    torn = [*lines[:9], *lines[10:14], other[7], *lines[14:]]
    log, faults = logs.read("\n".join(torn), "p1.log")
    assert sorted(reasons(faults)) == [
        (6, "replay.line_changed"),
        (10, "replay.lines_lack"),
        (14, "replay.other_session"),
    ]
    assert len(log.entries) == len(lines) - 2


def test_a_later_part_of_a_session_lacks_only_what_the_first_part_has():  # R-H02
    head, *lines = with_records(assembly(4.0)).splitlines()
    first, faults = logs.read("\n".join((head, *lines[:9])), "a.log")
    second, more = logs.read("\n".join((head, *lines[9:])), "a-2.log")
    assert (*faults, *more, *logs.doubts([first, second])) == ()
    assert [doubt.reason.key for doubt in logs.doubts([second])] == ["study.no_start"]


def test_what_a_runtime_told_is_nothing_that_a_subject_did():  # R-H02
    text = LogText().start().new().select(4).put(1, "runtime_event").insert(1).quit().text
    log, faults = logs.read(with_records(text), "p1.log")
    assert faults == ()
    assert [entry.event for entry in log.entries] == [
        "Start_Onika",
        "new_appl",
        "select_icon",
        "insert_icon",
        "Quit_Onika",
    ]
