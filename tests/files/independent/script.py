"""Appendix A's lines, read naively: what is left to read is a list that is eaten from the front.

Written from the appendix and the decisions on it alone, without a look at `onika.files`, as its judge. Anything that
the appendix does not allow raises ValueError.
"""

import re

NOT_PRINTABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]")


class Script:
    def __init__(self, text: str, versioned: bool = True, extended: bool = False) -> None:
        if NOT_PRINTABLE.search(text):
            raise ValueError("not printable")
        if text[:1] == "\ufeff":
            text = text[1:]
        self.left: list[tuple[str, str]] = []
        for raw in text.split("\n"):
            if "\r" in raw[:-1]:
                raise ValueError("not printable")
            line = raw.rstrip("\r").strip(" \t")
            if line == "" or line[0] == "#":
                continue
            keyword = line.replace("\t", " ").split(" ")[0]
            self.left.append((keyword, line[len(keyword) :].strip(" \t")))
        if not self.left or self.left[-1] != ("EOF", ""):
            raise ValueError("no EOF")
        self.left.pop()
        if any(keyword == "EOF" for keyword, _ in self.left):
            raise ValueError("EOF twice")
        self.is_old = False
        self.is_new = False
        if versioned:
            self.is_old = True
            if self.next == "VERSION":
                parts = [number(part) for part in self.take("VERSION").split(".")]
                if any(part < 0 for part in parts):
                    raise ValueError("version")
                while parts and parts[-1] == 0:
                    parts.pop()
                self.is_new = extended and parts == [2]
                if parts > [1, 3] and not self.is_new:
                    raise ValueError("newer")
                self.is_old = parts < [1, 3]

    @property
    def next(self) -> str:
        return self.left[0][0] if self.left else ""

    def take(self, keyword: str) -> str:
        """The rest of the next line, which must be this one."""
        if self.next != keyword or not self.left:
            raise ValueError(f"{keyword} wanted, {self.next} found")
        return self.left.pop(0)[1]

    def maybe(self, keyword: str, default: str) -> str:
        """As `take`, but a file older than 1.3 may lack the line."""
        if self.is_old and self.next != keyword:
            return default
        return self.take(keyword)

    def new(self, keyword: str) -> str | None:
        """As `take` where such a line is next, which only a file of 2.0 may have."""
        if self.next != keyword:
            return None
        if not self.is_new:
            raise ValueError(f"{keyword} in an older file")
        return self.take(keyword)

    def end(self) -> None:
        if self.left:
            raise ValueError(f"nothing wanted, {self.next} found")


def blanks(text: str) -> str:
    """Combinations of tabs and spaces are treated as one space."""
    return " ".join(word for word in text.replace("\t", " ").split(" ") if word)


def words(text: str) -> list[str]:
    return blanks(text).split(" ") if blanks(text) else []


def number(text: str) -> int:
    digits = text[1:] if text[:1] in "+-" else text
    if not digits or any(c not in "0123456789" for c in digits):
        raise ValueError(f"{text} is no whole number")
    return int(text)


def numbers(text: str) -> list[int]:
    return [number(word) for word in words(text)]


def real(text: str) -> float:
    if any(c not in "0123456789+-.eE" for c in text):
        raise ValueError(f"{text} is no number")
    value = float(text)
    if value - value != 0:
        raise ValueError(f"{text} is too large")
    return value


def yes(text: str) -> bool:
    return {"yes": True, "no": False}[text] if text in ("yes", "no") else _refuse(text)


def one_of(text: str, *choices: str) -> str:
    return text if text in choices else str(_refuse(text))


def one_word(text: str) -> str:
    return text if len(words(text)) == 1 else str(_refuse(text))


def _refuse(text: str) -> bool:
    raise ValueError(f"{text} is none of the words")


def name(text: str) -> str:
    """A task, an icon, a module."""
    letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
    if text[:1] not in letters or text == "" or any(c not in letters + "0123456789_.-" for c in text):
        raise ValueError(f"{text} is no name")
    return text


def svar(text: str) -> str:
    letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
    if text[:1] not in letters or text == "" or any(c not in letters + "0123456789_^" for c in text):
        raise ValueError(f"{text} is no state variable")
    return text


def condition(text: str) -> str:
    """A variable, perhaps of a flow and perhaps one of its elements, a relation and a decimal number."""
    left, relation, right = "", "", ""
    for at, sign in enumerate(text):
        if sign in "=!<>":
            relation = text[at : at + 2] if text[at + 1 : at + 2] == "=" else sign
            left, right = text[:at], text[at + len(relation) :]
            break
    if relation not in ("==", "!=", "<", ">", "<=", ">="):
        raise ValueError(text)
    real(right.strip())
    address, bracket, index = left.strip().partition("[")
    if bracket and not (index[-1:] == "]" and all(part.strip().isdecimal() for part in index[:-1].split(","))):
        raise ValueError(text)
    *where, variable = address.split("/")
    svar(variable)
    if len(where) > 2 or not all(name(item) for item in where):
        raise ValueError(text)
    return blanks(text)
