import pytest

from onika.web.login import Login

HOST = "127.0.0.1:8420"
COOKIE = "onika-8420"


def test_a_key_works_once_and_the_next_is_told():  # R-X11
    names = []
    login = Login((HOST,), names.append)
    first = login.key
    cookie = login.enter(first)
    assert login.knows({COOKIE: cookie})
    assert login.enter(first) is None
    assert names == [login.key] != [first]


@pytest.mark.parametrize("key", ["", "x", "é"])
def test_any_other_key_opens_nothing(key):
    assert Login((HOST,)).enter(key) is None


@pytest.mark.parametrize("cookies", [{}, {COOKIE: ""}, {COOKIE: "x"}, {"other": "x"}])
def test_an_unknown_cookie_is_nobodys(cookies):
    login = Login((HOST,))
    login.enter(login.key)
    assert not login.knows(cookies)


@pytest.mark.parametrize("headers", [{}, {"host": "evil.example:8420"}, {"host": "127.0.0.1:1"}])
def test_a_foreign_name_is_not_ours(headers):
    assert not Login((HOST,)).is_ours(headers)
    assert Login((HOST,)).is_ours({"host": HOST})


@pytest.mark.parametrize(
    "headers",
    [
        {"host": HOST},
        {"host": HOST, "origin": "null"},
        {"host": HOST, "origin": "http://evil.example"},
        {"host": HOST, "origin": "http://127.0.0.1:1"},
        {"host": "evil.example", "origin": "http://evil.example"},
        {"host": HOST, "origin": f"file://{HOST}"},
    ],
)
def test_only_a_page_that_came_from_here_may_talk(headers):
    assert not Login((HOST,)).is_own_page(headers)
    assert Login((HOST,)).is_own_page({"host": HOST, "origin": f"http://{HOST}"})


def test_a_page_of_another_of_our_names_may_not_talk():
    login = Login((HOST, "localhost:8420"))
    assert not login.is_own_page({"host": HOST, "origin": "http://localhost:8420"})


def test_two_environments_of_a_machine_have_cookies_of_their_own():  # R-X11
    logins = [Login((f"127.0.0.1:{port}", f"localhost:{port}")) for port in (8420, 8421)]
    browser = {login.cookie_name: login.enter(login.key) for login in logins}
    assert [login.knows(browser) for login in logins] == [True, True]
