"""Keys as a terminal sends them: bytes in, names of keys or letters out."""

import codecs
import re

_SEQUENCE = re.compile(r"\x1b(?:\[[0-?]*[ -/]*[@-~]|O[A-Za-z]|[^\[O])")
_HALF = re.compile(r"\x1b(?:\[[0-?]*[ -/]*|O)?\Z")

_NAMED = {
    "\r": "enter", "\n": "enter", "\t": "tab", "\x7f": "backspace", "\x08": "backspace",
    "\x01": "home", "\x02": "left", "\x04": "delete or end", "\x05": "end", "\x06": "right", "\x0b": "cut to end",
    "\x0c": "clear", "\x0e": "down", "\x10": "up", "\x15": "cut to start", "\x17": "cut word", "\x19": "paste",
    "\x1b[A": "up", "\x1b[B": "down", "\x1b[C": "right", "\x1b[D": "left", "\x1bOA": "up", "\x1bOB": "down",
    "\x1bOC": "right", "\x1bOD": "left", "\x1b[H": "home", "\x1b[F": "end", "\x1bOH": "home", "\x1bOF": "end",
    "\x1b[1~": "home", "\x1b[4~": "end", "\x1b[7~": "home", "\x1b[8~": "end", "\x1b[3~": "delete",
    "\x1bb": "word left", "\x1bf": "word right", "\x1b[1;5D": "word left", "\x1b[1;5C": "word right",
    "\x1bd": "cut word right", "\x1b\x7f": "cut word",
}  # fmt: skip


class Keys:
    """Keeps what is cut in the middle until the rest comes; keys it does not know are nothing."""

    def __init__(self) -> None:
        self._decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self._rest = ""

    def read(self, data: bytes) -> list[str]:
        """The keys of these bytes: a letter is itself, all else goes by a name of several letters."""
        text = self._rest + self._decoder.decode(data)
        self._rest = ""
        keys: list[str] = []
        while text:
            found = _SEQUENCE.match(text)
            if found is None and _HALF.match(text):
                self._rest = text
                break
            piece = found[0] if found else text[0]
            text = text[len(piece) :]
            if piece in _NAMED:
                keys.append(_NAMED[piece])
            elif len(piece) == 1 and piece.isprintable():
                keys.append(piece)
        return keys
