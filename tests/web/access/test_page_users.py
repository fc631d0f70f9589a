import pytest

from onika.link.caller import Role
from onika.web.access.page_users import PageUser, PageUserFile, parsed, users_path
from onika.web.access.password_hash import PasswordHash

KEPT = PasswordHash(b"s" * 16, b"d" * 32)
ANN = PageUser("ann", Role.OWNER, KEPT)
WIL = PageUser("wil", Role.VIEWER, KEPT)


def test_users_are_written_and_read_again(tmp_path):  # R-F10
    path = tmp_path / "state" / "page-users"
    file = PageUserFile(path)
    assert file.put(ANN) is None
    assert file.put(WIL) is None
    other = PageUserFile(path)
    assert other.look()
    assert other.users == {"ann": ANN, "wil": WIL}
    assert path.stat().st_mode & 0o077 == 0
    assert file.remove("ann") is None
    assert other.look()
    assert set(other.users) == {"wil"}


def test_the_file_is_read_anew_only_where_it_has_changed(tmp_path):
    file = PageUserFile(tmp_path / "users")
    file.put(ANN)
    assert file.look()
    assert not file.look()


def test_nobody_is_let_in_by_a_file_that_is_gone(tmp_path):  # R-F10
    file = PageUserFile(tmp_path / "users")
    file.put(ANN)
    file.look()
    file.path.unlink()
    assert file.look()
    assert file.users == {}


@pytest.mark.parametrize(
    "line",
    [
        "ann",
        "ann owner",
        f"ann king {KEPT}",
        f"an/n owner {KEPT}",
        f"{'a' * 33} owner {KEPT}",
        "ann owner secretpassword",
        f"ann owner {KEPT} more",
    ],
)
def test_a_line_that_is_none_lets_nobody_in_and_is_not_shown(line):  # R-X01
    users, faults = parsed(f"# users\n\n{line}\n{WIL}\n", "users")
    assert users == {"wil": WIL}
    assert [fault.place.line for fault in faults] == [3]
    assert "secretpassword" not in str(faults)


def test_of_two_lines_for_one_name_the_first_counts_and_that_is_told():  # R-X01
    users, faults = parsed(f"{ANN}\n{PageUser('ann', Role.VIEWER, KEPT)}\n", "users")
    assert users == {"ann": ANN}
    assert [fault.reason.key for fault in faults] == ["desk.user_twice"]


def test_they_lie_in_the_state_directory():
    assert str(users_path({"XDG_STATE_HOME": "/s"})) == "/s/onika/page-users"
