import signal

import pytest

from kit.process.cli_process import CliProcess

pytestmark = pytest.mark.site


def test_events_are_read_as_they_come_and_none_is_skipped():
    with CliProcess("run", "go_home", "--virtual", "--json") as console:
        began = console.until(event="began")
        assert began["action"] == "jmoveC home"
        assert console.until(event="done")["index"] == 0
        result = console.result()
    assert (result["event"], result["exit"], console.code()) == ("result", 0, 0)
    assert console.events[0]["event"] == "begins"
    assert len(console.events) == len(console.lines)


def test_an_event_that_does_not_come_before_the_end_is_an_error():
    with (
        CliProcess("run", "go_home", "--virtual", "--json") as console,
        pytest.raises(RuntimeError, match="no such thing"),
    ):
        console.until(event="no such thing")


def test_silence_beyond_the_patience_is_an_error():
    with CliProcess("run", "go_home", "--json", patience_s=0.05) as console, pytest.raises(TimeoutError):
        console.result()


def test_the_processes_of_a_run_are_found_and_seen_to_end():
    with CliProcess("run", "go_home", "--json") as console:
        console.until(event="drive", state="DRIVEN")
        for name in (
            "onika.host --link-fd",
            "onika.host.units.rtpu",
            "onika.host.units.device_server",
            "onika.host.loading.loader",
        ):
            assert console.process(name) in console.processes()
        console.interrupt()
        assert console.result()["state"] == "aborted"
        assert console.left_over() == []


def test_a_process_that_outlives_the_command_is_told():
    with CliProcess("run", "go_home", "--json") as console:
        console.until(event="drive", state="DRIVEN")
        left = console.left_over(0.1)  # asked too early: everything lives
        assert any("onika.host.units.rtpu" in words for words in left)
        console._process.send_signal(signal.SIGKILL)


def test_lines_that_are_no_events_are_kept_as_text():
    with CliProcess("run", "nothing_like_it") as console:
        assert "expected an application file" in console.text()
        assert console.events == []
        assert console.code() == 2


def test_a_line_is_waited_for_and_missed_where_the_output_ends_before():
    with CliProcess("--version") as console:
        assert console.until_line("onika").startswith("onika ")
        with pytest.raises(RuntimeError, match="expected 'never', found the end of the output"):
            console.until_line("never")
