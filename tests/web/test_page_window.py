import threading

import pytest

from onika.web import page_window
from onika.web.page_window import PageWindow
from onika.words.reason import reason_of


@pytest.fixture
def chromium(tmp_path, monkeypatch):
    """A browser that notes what it was told."""
    program = tmp_path / "bin" / "chromium"
    program.parent.mkdir()
    program.write_text(
        f'#!/bin/sh\nprintf "%s\\n" "$@" > {tmp_path}/told.new\nmv {tmp_path}/told.new {tmp_path}/told\n'
    )
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}:/usr/bin:/bin")
    monkeypatch.setattr(page_window, "_BROWSERS", ("chromium",))
    return program


@pytest.mark.parametrize(("text", "written"), [("1280x900", "1280x900+0+0"), ("900x700+40+8", "900x700+40+8")])
def test_a_window_is_read_and_written(text, written):  # R-H09
    assert str(PageWindow.read(text)) == written


@pytest.mark.parametrize("text", ["", "1280", "1280x", "12x90", "1280x900+0", "-1280x900", "1280x900+0+0+0", "axb"])
def test_what_is_no_window_is_refused(text):  # R-H09
    with pytest.raises(ValueError, match="window") as refused:
        PageWindow.read(text)
    assert reason_of(refused.value).key == "cli.window_expected"


def test_the_page_gets_its_size_its_place_and_a_browser_that_keeps_nothing_of_others(chromium, tmp_path):  # R-H09
    command = PageWindow(900, 700, 40, 8).command("http://127.0.0.1:1/?key=a", tmp_path / "kept")
    assert command[:2] == (str(chromium), "--app=http://127.0.0.1:1/?key=a")
    assert {"--window-size=900,700", "--window-position=40,8", f"--user-data-dir={tmp_path / 'kept'}"} <= {*command}
    assert PageWindow(900, 700).open("http://127.0.0.1:1/", tmp_path / "kept")


def test_who_opens_a_window_learns_that_it_was_closed(chromium, tmp_path):  # R-H09
    closed = threading.Event()
    assert PageWindow(900, 700).open("http://127.0.0.1:1/", tmp_path / "kept", closed.set)
    assert closed.wait(30)
    assert (tmp_path / "told").exists()  # by then it has come to its end


def test_where_no_browser_is_nothing_is_opened(tmp_path, monkeypatch):  # R-H09
    monkeypatch.setenv("PATH", str(tmp_path))
    assert PageWindow(900, 700).command("http://127.0.0.1:1/", tmp_path) == ()
    assert not PageWindow(900, 700).open("http://127.0.0.1:1/", tmp_path)
