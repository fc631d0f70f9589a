import stat
from concurrent.futures import ThreadPoolExecutor

import pytest

from onika.link.token import digest, new_token, own_token, read_token, token_path


def test_tokens_have_256_random_bits():
    assert len({new_token() for _ in range(100)}) == 100
    assert all(len(new_token()) == 43 for _ in range(10))


def test_the_token_lies_in_the_state_directory():
    assert str(token_path({"XDG_STATE_HOME": "/x", "HOME": "/h"})) == "/x/onika/token"
    assert str(token_path({"XDG_STATE_HOME": "relative", "HOME": "/h"})) == "/h/.local/state/onika/token"


def test_the_token_is_made_once_and_only_its_user_can_read_it(tmp_path):
    path = tmp_path / "state" / "onika" / "token"
    token = own_token(path)
    assert own_token(path) == token == read_token(path)
    assert stat.S_IMODE(path.stat().st_mode) == 0o600
    assert stat.S_IMODE(path.parent.stat().st_mode) == 0o700
    assert [path_.name for path_ in path.parent.iterdir()] == ["token"]


def test_of_programs_that_start_at_once_the_first_ones_token_stands(tmp_path):
    with ThreadPoolExecutor(8) as pool:
        made = set(pool.map(lambda _: own_token(tmp_path / "token"), range(40)))
    assert made == {read_token(tmp_path / "token")}


def test_a_token_that_others_can_read_is_not_used(tmp_path):
    path = tmp_path / "token"
    own_token(path)
    path.chmod(0o644)
    with pytest.raises(ValueError, match="chmod 600"):
        own_token(path)


@pytest.mark.parametrize("text", ["", "  \n", "two words", "zwei\x00"])
def test_a_file_without_a_token_is_told(tmp_path, text):
    (tmp_path / "token").write_text(text)
    with pytest.raises(ValueError, match="expected one token"):
        read_token(tmp_path / "token")


def test_what_is_kept_of_a_token_is_its_digest():
    assert digest("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
