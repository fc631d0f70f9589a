"""The limits within which a server of libraries has to answer."""

from dataclasses import dataclass

from onika.files.library_index import LARGEST_FILE


@dataclass(frozen=True, slots=True)
class Limits:
    """How much, how long and how slowly a server may answer, whoever it is; for one answer.

    file_bytes  of one file
    connect_s   until the server has taken the connection
    idle_s      without a byte
    total_s     from question to the last byte
    rate        bytes a second that come at least, once `grace_s` have passed
    grace_s     in which an answer may be slower
    redirects   how often a server may send us on, to itself
    """

    file_bytes: int = LARGEST_FILE
    connect_s: float = 10.0
    idle_s: float = 15.0
    total_s: float = 60.0
    rate: float = 500.0
    grace_s: float = 10.0
    redirects: int = 3
