import pytest

from onika.files.state.staying_runtime import StayingFile, StayingRuntime, staying_path, staying_runtime


def test_a_runtime_that_stays_is_found_as_long_as_it_lives(tmp_path):  # R-A15
    path = staying_path({"XDG_STATE_HOME": str(tmp_path / "state")})
    assert staying_runtime(path) is None
    file = StayingFile(path)
    assert staying_runtime(path) is None, "it does not listen yet"
    file.say(StayingRuntime(4711, 12))
    assert staying_runtime(path) == StayingRuntime(4711, 12)
    assert path.stat().st_mode & 0o077 == 0
    file.close()
    assert staying_runtime(path) is None


def test_one_that_died_without_a_word_is_none(tmp_path):  # R-A15
    path = tmp_path / "staying"
    path.write_text('{"port":4711,"process":12}\n')
    assert staying_runtime(path) is None
    file = StayingFile(path)
    assert staying_runtime(path) is None, "what the last one said is not taken for the word of this one"
    file.close()


def test_only_one_stays(tmp_path):  # R-A15
    path = tmp_path / "staying"
    file = StayingFile(path)
    file.say(StayingRuntime(4711, 12))
    with pytest.raises(BlockingIOError):
        StayingFile(path)
    assert staying_runtime(path) == StayingRuntime(4711, 12), "the first one stays where it is"
    file.close()


@pytest.mark.parametrize("text", ["garbage\n", '{"port":4711}\n', '{"port":4711,"process":12}'])
def test_a_file_that_says_nothing_of_use_names_nobody(tmp_path, text):  # R-A15
    path = tmp_path / "staying"
    file = StayingFile(path)
    path.write_text(text)
    assert staying_runtime(path) is None
    file.close()
