"""Texts that leave the machine: paths in them do not name whose home they lie in."""

import re

_HOME = re.compile(r"(?:/home/|/Users/)[^/\"'\s:;,<>\\]+|(?<![\w.])/root(?=/)|[A-Za-z]:\\+Users\\+[^\\\"'/\s:;,<>]+")
SIGN = "~"


def homeless(text: str, home: str = "") -> str:
    """The text with `~` in place of every home directory, this user's (`home`) and those of any other machine."""
    own = home.rstrip("/")
    if own.count("/") > 0 and own != "":
        text = re.sub(rf"(?<![\w.]){re.escape(own)}(?=/|\"|'|\s|$)", SIGN, text)
    return _HOME.sub(SIGN, text)
