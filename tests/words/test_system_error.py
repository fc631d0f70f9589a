import errno
import os

import pytest

from onika.words.reason import Reason, in_language
from onika.words.system_error import is_used_up, system_reason, system_reason_with_place


@pytest.mark.parametrize(
    ("code", "key"),
    [
        (errno.ENOSPC, "words.disk_full"),
        (errno.EROFS, "words.disk_read_only"),
        (errno.EMFILE, "words.descriptors_used"),
        (errno.ENOMEM, "words.memory_used"),
        (errno.EACCES, "words.not_permitted"),
    ],
)
def test_what_is_used_up_is_said_in_words_of_its_own(code, key):  # R-B07, R-X01
    assert system_reason(OSError(code, os.strerror(code))).key == key


def test_anything_else_is_said_as_the_system_says_it():
    assert str(system_reason(OSError(errno.EXDEV, "Invalid cross-device link"))) == "Invalid cross-device link"


def test_what_happens_often_is_said_in_the_words_of_the_system_and_in_spanish():  # R-G03
    missing = system_reason(FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT)))
    assert (str(missing), in_language(missing, "es")) == (
        os.strerror(errno.ENOENT),
        "no existe ese archivo o directorio",
    )


def test_a_reason_that_it_was_raised_with_is_kept():
    assert system_reason(OSError(Reason.of("words.left_out"))).key == "words.left_out"


def test_the_file_is_named_where_there_is_one():
    full = OSError(errno.ENOSPC, "No space left on device", "/disk/a")
    assert str(system_reason_with_place(full)) == "/disk/a: no space is left on that disk"
    assert str(system_reason_with_place(OSError(errno.ENOSPC, "x"))) == "no space is left on that disk"


def test_what_the_system_has_no_more_of_is_told_from_what_it_does_not_allow():
    assert is_used_up(OSError(errno.EMFILE, "x"))
    assert not is_used_up(OSError(errno.EACCES, "x"))
    assert not is_used_up(OSError("x"))
