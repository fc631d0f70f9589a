import pytest

from kit.labs.library_site import WINK_CODE, wink
from onika.agent.change_check import ChangeCheck
from onika.store.site import open_site
from onika.words.reason import NOTHING


@pytest.fixture(scope="module")
def check(tmp_path_factory):
    types, _ = open_site([], {}, tmp_path_factory.mktemp("home")).syntax()
    return ChangeCheck(types)


@pytest.mark.parametrize(
    ("path", "content"),
    [
        ("module/wink.rmod", wink().encode()),
        ("module/wink.py", WINK_CODE.encode()),
        ("module/words.toml", b"anything"),
        ("net/eye.onnx", b"\xff\x00"),
        ("robot/arm.dta", b"\xff\x00"),
    ],
)
def test_what_can_be_read_is_taken(check, path, content):  # R-F03
    assert check.refusal(path, content) == NOTHING


def test_code_is_read_and_never_executed(check, tmp_path):  # R-F03
    mark = tmp_path / "mark"
    assert check.refusal("module/x.py", f"open({str(mark)!r}, 'w')".encode()) == NOTHING
    assert check.refusal("module/x.py", b"x = \0").key == "site.file_at_fault"
    assert check.refusal("module/x.py", b"(" * 100_000).key == "site.file_at_fault"
    assert not mark.exists()


def test_the_first_fault_of_a_file_is_told_with_its_line(check):  # R-F03
    refusal = check.refusal("module/wink.rmod", wink().replace("periodic", "sometimes").encode())
    assert refusal.key == "site.file_at_fault" and "wink.rmod:7" in str(refusal)
