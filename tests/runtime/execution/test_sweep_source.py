"""The text of a sweep: its order, whom it copies from, and names that never meet."""

import ast

import pytest

from onika.runtime.execution.sweep_source import SweepMember, SweepPort, sweep_source

Q = SweepPort("flow0", "Q", 64, 48)
TAU = SweepPort("flow0", "TAU", 9000, 48)
PICTURE = SweepPort("flow0", "PICTURE", 20_000, 16_384)


def member(name, inputs=(), outputs=(), *, is_hardware=False, subsystem="flow0"):
    return SweepMember(subsystem, name, is_hardware, tuple(inputs), tuple(outputs))


def lines(*members, **given):
    return [line.strip() for line in sweep_source(members, **given).text.splitlines()]


def test_tasks_run_in_the_order_given_and_the_clock_is_read_once_between_two():  # R-X06, law 1
    text = lines(member("a", outputs=[Q]), member("b", [Q]), member("c"))
    calls = [line for line in text if line.endswith("cycle()")]
    assert calls == ["signal = a.cycle()", "signal = b.cycle()", "signal = c.cycle()"]
    assert [line for line in text if "clock()" in line] == [f"lap[{place}] = clock()" for place in range(4)]


def test_what_was_just_published_comes_from_its_writer_and_all_else_from_the_table():  # laws 1, 2
    text = lines(member("first", [TAU]), member("writer", outputs=[Q]), member("reader", [Q], [TAU]))
    assert "reader_Q[ALL] = writer_Q" in text
    assert "first_TAU[ALL] = TAU_slots[TAU_words[0] & 63]" in text  # a value of the last sweep


def test_what_nobody_in_the_sweep_writes_is_copied_where_it_has_changed():
    text = lines(member("reader", [Q, PICTURE]))
    assert "if reader_Q_seen[0] != Q_words[0]:" in text
    assert "reader_PICTURE[ALL] = PICTURE_slots[PICTURE_words[0] & 3]" in text


def test_a_short_value_is_sealed_once_in_eight_and_a_long_one_is_not():  # R-A12
    text = lines(member("a", outputs=[Q, PICTURE]))
    assert "if not count & 7: Q_words[2] = seal_of(a_Q, count)" in text
    assert not any("seal_of" in line and "PICTURE" in line for line in text)


def test_a_hardware_task_is_given_its_inputs_by_its_guard():  # laws 4, 5, 33
    text = lines(member("puma", [TAU], [Q], is_hardware=True))
    at = text.index("if puma_guard.take_in(now):")
    assert text[at + 1 : at + 5] == ["signal = puma.cycle()", "else:", "puma.hold()", "signal = None"]
    assert "puma_TAU[ALL]" not in " ".join(text)


def test_whose_code_runs_is_noted_at_each_task():  # law 15
    assert "running.task = 'flow0/b'" in lines(member("a"), member("b"))
    assert "last_words[ALL] = b_name" in lines(member("a"), member("b"), notes_name=True)


@pytest.mark.parametrize("name", ["lap", "ALL", "class", "now", "a-b", "2d", "ä", "sweep", "a.b", "running", "_"])
def test_any_name_of_a_task_becomes_one_of_python_and_no_two_meet(name):
    members = [member(name, [Q], [TAU]), member(name, [Q], subsystem="flow1"), member("a_b"), member("lap_2")]
    source = sweep_source(members)
    ast.parse(source.text)
    names = [entry.name for entry in source.names]
    assert len(set(names)) == len(names)
    assert all(entry.isidentifier() for entry in names)


def test_a_variable_of_two_subsystems_is_two():
    other = SweepPort("flow1", "Q", 64, 48)
    text = lines(member("a", outputs=[Q]), member("b", [other], subsystem="flow1"))
    assert "b_Q[ALL] = a_Q" not in text


def test_a_name_with_quotes_in_it_is_a_text_and_no_code():
    text = sweep_source([member('x"""; import os #', subsystem='f"""')]).text
    assert len(ast.parse(text).body) == 1
    assert not [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Import)]
