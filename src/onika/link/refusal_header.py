"""The header that tells programs why an HTTP request was refused; people read the sentence that comes with it."""

import json

import msgspec

from onika.words.reason import Reason

HEADER = "Onika-Reason"
"""Of an answer that refuses: the reason as JSON in ASCII, with key, arguments and the sentence in English."""
LONGEST = 2000
"""Characters of a header that are believed."""

_decoder = msgspec.json.Decoder(Reason)


def written(reason: Reason) -> str:
    """The header of a reason."""
    return json.dumps(msgspec.to_builtins(reason))


def read(header: str) -> Reason | None:
    """The reason of a header; None: it says none."""
    if len(header) > LONGEST:
        return None
    try:
        return _decoder.decode(header)
    except (msgspec.DecodeError, UnicodeError, RecursionError):
        return None
