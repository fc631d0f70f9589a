import pytest

from onika.web.access.password_hash import NOBODY, PasswordHash, unfit

CHEAP = {"cost": 4, "lanes": 1}


def test_a_password_is_known_again_and_no_other():  # R-F10
    kept = PasswordHash.of("correct horse battery", **CHEAP)
    assert kept.matches("correct horse battery")
    assert not kept.matches("correct horse batterx")
    assert not kept.matches("")
    assert "correct" not in str(kept)


def test_what_is_written_is_read_again_and_costs_a_thief_what_it_should():  # R-F10
    kept = PasswordHash.of("correct horse battery")
    assert PasswordHash.parse(str(kept)) == kept
    assert PasswordHash.parse(str(kept)).matches("correct horse battery")
    assert str(kept).startswith("scrypt:15:3:")


def test_two_users_with_one_password_cannot_be_told_by_what_is_kept():
    assert PasswordHash.of("correct horse battery", **CHEAP) != PasswordHash.of("correct horse battery", **CHEAP)


def test_letters_that_look_the_same_are_the_same():
    assert PasswordHash.of("contraseña larga", **CHEAP).matches("contrasen\u0303a larga")


@pytest.mark.parametrize(
    "text",
    [
        "",
        "scrypt",
        "scrypt:15:3:00:00",
        f"scrypt:4:1:{'00' * 16}:{'00' * 32}",  # too cheap
        f"scrypt:40:3:{'00' * 16}:{'00' * 32}",  # more memory than there is
        f"scrypt:15:3000:{'00' * 16}:{'00' * 32}",
        f"md5:15:3:{'00' * 16}:{'00' * 32}",
        f"scrypt:15:3:{'zz' * 16}:{'00' * 32}",
        f"scrypt:15:3:{'00' * 16}:{'00' * 32}:x",
    ],
)
def test_anything_else_is_no_hash(text):  # R-X01
    with pytest.raises(ValueError):
        PasswordHash.parse(text)


def test_nobody_has_no_password():
    assert not NOBODY.matches("")


@pytest.mark.parametrize(
    ("password", "key"),
    [
        ("short", "desk.password_length"),
        ("x" * 257, "desk.password_length"),
        ("Annaliese12345", "desk.password_guessable"),
        ("aaaaaaaaaaaa", "desk.password_guessable"),
        ("correct horse battery", ""),
    ],
)
def test_a_password_that_is_guessed_at_once_is_refused(password, key):  # R-F10
    assert unfit(password, "annaliese").key == key
