import pytest

from onika.cli import console as room, main


class Reached:
    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass


@pytest.fixture
def sits(monkeypatch):
    """To what would have been connected, and how the console would have been held."""
    seen = []
    monkeypatch.setattr(room, "connect", lambda *given: seen.append(given) or Reached())
    monkeypatch.setattr(room, "sit_down", lambda runtime, site, script, **given: seen.append((script, given)) or 0)
    return seen


def test_a_console_is_held_with_a_runtime_that_runs_already(sits, tmp_path):  # R-A16
    token = tmp_path / "token"
    token.write_text("abc\n")
    assert main(["console", "ws://127.0.0.1:7994", "--token-file", str(token)]) == 0
    assert sits == [("ws://127.0.0.1:7994", "abc", None), (None, {"has_console": True})]


def test_a_script_may_be_all_of_it(sits, tmp_path):
    path = tmp_path / "start"
    path.write_text("")
    assert main(["console", "ws://127.0.0.1:7994", "--script", str(path), "--no-console"]) == 0
    assert sits[1] == (path, {"has_console": False})


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["http://127.0.0.1:7994"], "expected ws://HOST:PORT, wss://HOST:PORT, ssh://HOST or site://HOST/NAME"),
        (["ws://example.org:7994"], "expected wss:// for another machine"),
        (["ws://127.0.0.1:7994", "--no-console"], "expected --script with --no-console"),
    ],
)
def test_a_wrong_command_line_is_told_and_ends_with_2(capsys, words, sentence):
    with pytest.raises(SystemExit) as ended:
        main(["console", *words])
    assert ended.value.code == 2
    assert sentence in capsys.readouterr().err


def test_a_token_file_that_is_not_there_is_told(sits, tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        main(["console", "ws://127.0.0.1:7994", "--token-file", str(tmp_path / "none")])
    assert ended.value.code == 2
    assert f"{tmp_path / 'none'}: No such file or directory" in capsys.readouterr().err
