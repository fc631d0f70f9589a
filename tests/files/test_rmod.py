from dataclasses import replace

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.files.rmod import RmodText, read, write
from onika.model.task import LocalLine, Task, TaskType
from onika.words.reason import Reason

TEXT = """\
##### joint path

MODULE      quintic
DESC        path of  fifth order

SVARALIAS   JOINTS = NDOF
SVARALIAS   OUT=Q_REF
INCONST     JOINTS
OUTCONST    none
INVAR       Q_MEZ
OUTVAR      OUT Q^_REF
TASKTYPE    periodic

FREQ        500

ONIKA
OBJECT      Joint job

LOCAL
QMIN        -2.8 -2.8    # these are words
# a comment
GAIN        1e3

EOF
"""
TASK = Task(
    name="jmove",
    module="quintic",
    description="path of fifth order",
    aliases=(("JOINTS", "NDOF"), ("OUT", "Q_REF")),
    inconst=("JOINTS",),
    invar=("Q_MEZ",),
    outvar=("OUT", "Q^_REF"),
    type=TaskType.PERIODIC,
    frequency=500.0,
    object_type="Joint job",
    local=(LocalLine("QMIN", ("-2.8", "-2.8", "#", "these", "are", "words")), LocalLine("GAIN", ("1e3",))),
)


def result(text: str) -> list[str]:
    record, faults = read(text, "jmove", "jmove.rmod")
    assert (record is None) == bool(faults)
    assert all(str(fault.instead) == "the task is left out" for fault in faults)
    return [f"{fault.place.line}: {fault.reason}" for fault in faults]


def changed(old: str, new: str) -> list[str]:
    assert old in TEXT
    return result(TEXT.replace(old, new, 1))


def test_a_task_is_read_as_the_file_says() -> None:
    assert read(TEXT, "jmove", "jmove.rmod") == (RmodText(TASK, TEXT), ())  # R-B01


def test_an_untouched_file_is_written_as_it_was() -> None:
    for text in (TEXT, TEXT.replace("\n", "\r\n"), TEXT + "# after the end"):
        record, _ = read(text, "jmove", "jmove.rmod")  # R-B01
        assert record
        assert write(record) == text


def test_a_changed_rate_changes_one_line() -> None:
    record, _ = read(TEXT, "jmove", "jmove.rmod")  # R-B01, R-C04
    assert record
    assert write(record, replace(TASK, frequency=250.0)) == TEXT.replace("FREQ        500", "FREQ        250")


def test_a_changed_alias_changes_one_line() -> None:
    record, _ = read(TEXT, "jmove", "jmove.rmod")  # R-C04
    assert record
    aliases = (("JOINTS", "NDOF"), ("OUT", "Q_GOAL"))
    assert write(record, replace(TASK, aliases=aliases)) == TEXT.replace("OUT=Q_REF", "OUT = Q_GOAL")


def test_a_rate_is_rewritten_as_period_when_wanted() -> None:
    record, _ = read(TEXT, "jmove", "jmove.rmod")
    assert record
    assert write(record, replace(TASK, gives_period=True)) == TEXT.replace("FREQ        500", "PERIOD      0.002")


def test_every_fault_is_named_at_once() -> None:
    text = TEXT.replace("MODULE      ", "MODULE ./").replace("Q_MEZ", "q_mez").replace("FREQ        500", "FREQ -1")
    assert result(text.replace("EOF\n", "")) == [  # R-B07
        "3: expected the name of a module after MODULE, found 'MODULE ./quintic'",
        "10: expected names of state variables or none after INVAR, found 'INVAR q_mez'",
        "14: expected a number above 0 (Hz) after FREQ, found 'FREQ -1'",
        "22: expected EOF as the last line, found the end of the file after 'GAIN 1e3'",
    ]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("Q_MEZ", "Q_MEZ Q_MEZ", "10: expected every name once, found 'INVAR Q_MEZ Q_MEZ'"),
        (
            "OUTCONST    none",
            "OUTCONST",
            "9: expected names of state variables or none after OUTCONST, found 'OUTCONST'",
        ),
        (
            "OUTCONST    none",
            "OUTCONST X none",
            "9: expected names of state variables or none after OUTCONST, found 'OUTCONST X none'",
        ),
        (
            "OUTCONST    none",
            "OUTCONST NONE",
            "9: expected names of state variables or none after OUTCONST, found 'OUTCONST NONE'",
        ),
        (
            "OUT=Q_REF",
            "OUT",
            "7: expected SVARALIAS CODED = SVAR with names of state variables, found 'SVARALIAS OUT'",
        ),
        ("OUT=Q_REF", "JOINTS=N", "7: expected one alias of JOINTS, found 'SVARALIAS JOINTS=N'"),
        ("OUT=Q_REF", "NOWHERE=X", "7: expected an alias of a port of this task, found 'SVARALIAS NOWHERE=X'"),
        ("OUT=Q_REF", "OUT=Q^_REF", "11: expected one output for each variable, found OUT and Q^_REF as Q^_REF"),
        ("periodic", "aperiodic", "14: expected no FREQ and no PERIOD for an aperiodic task, found 'FREQ 500'"),
        (
            "periodic",
            "often",
            "12: expected periodic, synchronous or aperiodic after TASKTYPE, found 'TASKTYPE often'",
        ),
        ("FREQ        500", "", "12: expected FREQ or PERIOD for a periodic task, found neither"),
        ("FREQ        500", "FREQ 500\nPERIOD 0.002", "15: expected either FREQ or PERIOD, found both"),
        ("FREQ        500", "FREQ 0", "14: expected a number above 0 (Hz) after FREQ, found 'FREQ 0'"),
        ("FREQ        500", "FREQ inf", "14: expected a number above 0 (Hz) after FREQ, found 'FREQ inf'"),
        ("FREQ        500", "FREQ 1e999", "14: expected a number above 0 (Hz) after FREQ, found 'FREQ 1e999'"),
        ("FREQ        500", "PERIOD nan", "14: expected a number above 0 (s) after PERIOD, found 'PERIOD nan'"),
        (
            "FREQ        500",
            "PERIOD 1e-310",
            "14: expected a period that is no fraction of nothing, found 'PERIOD 1e-310'",
        ),
        ("ONIKA\n", "\n", "17: expected ONIKA before OBJECT, found none"),
        ("OBJECT      Joint job\n", "\n", "16: expected OBJECT after ONIKA, found none"),
        (
            "Joint job",
            "Joint object",
            "17: expected a type of job such as Joint job after OBJECT, found 'OBJECT Joint object'",
        ),
        ("GAIN ", "?? ", "22: expected the name of a parameter, found '?? 1e3'"),
        ("GAIN ", "OBJECT ", "22: expected OBJECT before LOCAL, found 'OBJECT 1e3'"),
        ("LOCAL\n", "LOCAL x\n", "19: expected LOCAL alone on its line, found 'LOCAL x'"),
        ("DESC ", "DESK ", "4: expected DESC, found 'DESK path of fifth order'"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(old: str, new: str, expected: str) -> None:
    assert expected in changed(old, new)  # R-B07


def test_a_parameter_given_twice_is_noted_and_both_lines_stay() -> None:
    record, (note,) = read(TEXT.replace("# a comment", "GAIN 3"), "jmove", "f")  # R-B01
    assert record
    assert note.is_note
    assert (note.place.line, note.reason, str(note.instead)) == (
        22,
        Reason.of("files.keyword_once", keyword="GAIN", line="'GAIN 1e3'"),
        "the last one counts",
    )
    assert write(record, replace(record.task, frequency=1.0)) == TEXT.replace("# a comment", "GAIN 3").replace(
        "FREQ        500", "FREQ        1"
    )


def test_the_order_of_lines_is_law() -> None:
    text = TEXT.replace("MODULE      quintic\n", "").replace("TASKTYPE", "MODULE quintic\nTASKTYPE")
    assert result(text) == ["11: expected MODULE before OUTVAR, found 'MODULE quintic' after it"]  # reading 41


def test_a_port_line_may_give_an_aliased_name() -> None:
    record, _ = read(TEXT.replace("INCONST     JOINTS", "INCONST NDOF"), "jmove", "f")  # reading 8
    assert record
    assert record.task == TASK


def test_aliases_may_exchange_two_names() -> None:
    text = TEXT.replace("JOINTS = NDOF", "Q_MEZ = N").replace("OUT=Q_REF", "N = Q_MEZ").replace("JOINTS", "N")
    record, faults = read(text.replace("OUTVAR      OUT", "OUTVAR     "), "t", "f")  # R-C04
    assert faults == ()
    assert record
    assert record.task.svars(("N", "Q_MEZ")) == ("Q_MEZ", "N")


def test_a_file_with_nothing_but_eof_is_no_task() -> None:
    assert result("EOF")[0] == "1: expected a line MODULE, found none"


def test_onika_and_local_blocks_may_be_absent() -> None:
    text = "MODULE m\nDESC\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR none\nTASKTYPE aperiodic\nEOF"
    record, faults = read(text, "t", "f")
    assert faults == ()
    assert record
    assert record.task == Task("t", "m", type=TaskType.APERIODIC)


@pytest.mark.parametrize(("period", "frequency"), [("0.004", 250.0), ("0.1", 10.0), ("1e-3", 1000.0), ("3", 1 / 3)])
def test_a_period_is_exactly_its_frequency(period: str, frequency: float) -> None:
    record, _ = read(TEXT.replace("FREQ        500", f"PERIOD {period}"), "t", "f")
    assert record
    assert record.task.frequency == frequency


@given(st.floats(1e-200, 1e200))
@settings(max_examples=examples(200), deadline=None)
def test_every_rate_survives_being_written_as_period(frequency: float) -> None:
    text = write(RmodText(replace(TASK, frequency=frequency, gives_period=True)))  # R-B08
    record, _ = read(text, "jmove", "f")
    assert record
    assert record.task.frequency == frequency


def test_further_targets_stand_behind_the_type_of_the_job() -> None:
    text = "MODULE m\nDESC\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR none\nTASKTYPE aperiodic\n"  # R-D13
    text += "ONIKA\nOBJECT Joint job\nTARGET Cartesian  object\nTARGET Joint object\nLOCAL\nTARGET 3\nEOF\n"
    record, faults = read(text, "t", "f")
    assert faults == ()
    assert record
    assert (record.task.object_type, record.task.more_targets) == ("Joint job", ("Cartesian object", "Joint object"))
    assert [line.key for line in record.task.local] == ["TARGET"]  # a parameter may be called so, as before
    fresh = write(RmodText(record.task))
    assert "OBJECT      Joint job\nTARGET      Cartesian object\nTARGET      Joint object\n" in fresh
    again, _ = read(fresh, "t", "f")
    assert again
    assert again.task == record.task
    for wrong, key in (
        (text.replace("OBJECT Joint job\n", ""), "files.object_before_target"),
        (text.replace("TARGET Joint object", "TARGET Joint job"), "files.type_of_target"),
        (text.replace("TARGET Joint object", "TARGET object"), "files.type_of_target"),
    ):
        assert key in [fault.reason.key for fault in read(wrong, "t", "f")[1]]
