import pytest

from onika.host.sessions.users import User, Users, add_user, main, read
from onika.link.caller import Role
from onika.link.token import digest

ANN = User("ann", Role.VIEWER, digest("anns"))


def test_users_are_read_as_they_are_written():
    text = f"# who may\n\n{ANN}\nbob owner {digest('bobs')}\n"
    users, faults = read(text, "users")
    assert faults == []
    assert users == (ANN, User("bob", Role.OWNER, digest("bobs")))


@pytest.mark.parametrize(
    "line", ["ann", "ann viewer", "ann king " + "0" * 64, "ann viewer s3cret", "a/b viewer " + "0" * 64, "a b c d"]
)
def test_a_line_that_is_none_is_told_with_its_place_and_without_what_may_be_a_token(line):
    users, (fault,) = read(f"{ANN}\n{line}\n", "users")
    assert users == (ANN,)
    assert str(fault.place) == "users:2"
    assert "s3cret" not in str(fault)


def test_one_user_has_one_role_and_may_have_several_tokens():
    users, faults = read(f"{ANN}\nann viewer {digest('other')}\nann owner {digest('x')}\n", "users")
    assert (len(users), len(faults)) == (2, 1)


def test_a_user_is_found_by_his_token_only():  # R-X12
    users = Users((ANN,))
    assert users.find("anns") is ANN
    assert users.find("") is users.find("ann") is users.find(ANN.digest) is None


def test_the_command_makes_a_token_and_keeps_its_digest_only(tmp_path, capsys):
    file = tmp_path / "users"
    assert main(["ann", "operator", str(file)]) == 0
    token = capsys.readouterr().out.strip()
    assert file.read_text() == f"ann operator {digest(token)}\n"
    assert main(["ann", "operator"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 2
    for words in ([], ["ann"], ["ann", "king"], ["a b", "owner"]):
        assert main(words) == 2


def test_a_user_has_several_tokens_but_one_role(tmp_path):  # R-F02
    file = tmp_path / "users"
    file.write_text(str(ANN))  # somebody has left out the end of the line
    first, second = add_user(file, "bob", "viewer"), add_user(file, "bob", "viewer")
    users, faults = read(file.read_text(), "users")
    assert not faults and [Users(users).find(token).name for token in (first, second)] == ["bob", "bob"]
    before = file.read_text()
    for name, role in (("bob", "owner"), ("bob", "king"), ("b b", "viewer")):
        with pytest.raises(ValueError, match=name):
            add_user(file, name, role)
    assert file.read_text() == before
