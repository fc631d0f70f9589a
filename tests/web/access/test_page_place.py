import pytest

from onika.link.caller import Role
from onika.web.access.page_place import PageOptions, judged
from onika.web.access.page_users import PageUser, PageUserFile
from onika.web.access.password_hash import PasswordHash

USER = PageUser("ann", Role.OWNER, PasswordHash(b"s" * 16, b"d" * 32))


@pytest.fixture
def users(tmp_path):
    PageUserFile(tmp_path / "users").put(USER)
    return str(tmp_path / "users")


def test_with_certificate_key_and_a_user_the_page_is_served(certificate, users):  # R-F10
    place, faults = judged(PageOptions("0.0.0.0:8443", *certificate, users, ("robot.example",)), 8420)
    assert faults == []
    assert (place.host, place.port) == ("0.0.0.0", 8443)
    assert place.address(1) == "https://robot.example:1/"
    assert "0.0.0.0" not in place.names
    place, _ = judged(PageOptions("10.1.2.3", *certificate, users), 8420)
    assert (place.port, place.address(8420)) == (8420, "https://10.1.2.3:8420/")


def test_the_address_is_one_for_which_the_certificate_is(certificate):  # R-X25, R-F10
    def address(listen, *names):
        place, _ = judged(PageOptions(listen, *certificate, names=names), 8420, needs_users=False)
        return place.address(8420)

    assert address("127.0.0.1", "localhost") == "https://localhost:8420/"
    assert address("10.1.2.3", "robot.example", "localhost") == "https://localhost:8420/"
    assert address("127.0.0.1", "robot.example") == "https://127.0.0.1:8420/"
    assert address("10.1.2.3", "robot.example") == "https://robot.example:8420/"  # for none of them


def keys(wanted):
    place, faults = judged(wanted, 8420, {"XDG_STATE_HOME": "/nowhere"})
    assert place is None
    return [fault.reason.key for fault in faults]


def test_nothing_begins_without_all_of_it_and_all_that_is_missing_is_told(certificate, users, tmp_path):  # R-F10, R-X01
    missing = "desk.page_certificate_missing"
    assert keys(PageOptions("0.0.0.0")) == [missing, missing, "desk.page_without_users"]
    assert keys(PageOptions("127.0.0.1", users=users)) == [missing, missing]  # on this machine, too: passwords
    assert keys(PageOptions("0.0.0.0", certificate[0], "", users)) == [missing]
    assert keys(PageOptions("0.0.0.0", *reversed(certificate), users)) == ["desk.page_certificate_unfit"]
    assert keys(PageOptions("0.0.0.0", *certificate, str(tmp_path / "none"))) == ["desk.page_without_users"]
    assert keys(PageOptions("a/b", *certificate, users)) == ["desk.listen_form"]


def test_users_that_others_could_change_are_closed_to_them(certificate, users, tmp_path, monkeypatch):  # R-X12
    (tmp_path / "users").chmod(0o666)
    assert judged(PageOptions("0.0.0.0", *certificate, users), 8420)[1] == []
    assert (tmp_path / "users").stat().st_mode & 0o077 == 0
    (tmp_path / "users").chmod(0o666)
    monkeypatch.setattr("pathlib.Path.chmod", lambda *_: None)
    assert keys(PageOptions("0.0.0.0", *certificate, users)) == ["files.access_open"]
