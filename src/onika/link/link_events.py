"""The events that an end of the link reports to its owner."""

from dataclasses import dataclass
from enum import Enum

from onika.link.lost import LinkLost
from onika.link.state import LinkState
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class LinkStateChanged:
    """The link changed its state; `lost` says why where a connection ended."""

    state: LinkState
    lost: LinkLost | None = None


@dataclass(frozen=True, slots=True)
class EpochChanged:
    """To the environment: this is another life of the runtime, or the first; whatever was known of it is void."""

    epoch: str


@dataclass(frozen=True, slots=True)
class Resumed:
    """To the environment: the link goes on where it was cut; nothing was missed."""

    epoch: str


@dataclass(frozen=True, slots=True)
class SignalReceived:
    """To the environment: the next signal; `seq` is one more than that of the one before in this epoch."""

    seq: int
    body: bytes


@dataclass(frozen=True, slots=True)
class ReplyReceived:
    """To the environment: the answer to its request."""

    number: int
    body: bytes


class RequestFate(Enum):
    """What became of a request that got no answer."""

    UNSENT = "link.fate_unsent"
    LATE = "link.fate_late"
    LOST = "link.fate_lost"
    TOO_LONG = "link.fate_too_long"

    @property
    def reason(self) -> Reason:
        """The same as a sentence."""
        return Reason.of(self.value)


@dataclass(frozen=True, slots=True)
class RequestFailed:
    """To the environment: this request gets no answer any more."""

    number: int
    fate: RequestFate


@dataclass(frozen=True, slots=True)
class ReadingReceived:
    """To the environment: the newest value under a key."""

    key: str
    body: bytes


@dataclass(frozen=True, slots=True)
class Greeted:
    """To the runtime: this environment is there; not resumed means that it begins anew."""

    client: str
    resumed: bool


@dataclass(frozen=True, slots=True)
class RequestReceived:
    """To the runtime: carry this out, once, and reply under the ticket."""

    ticket: int
    client: str
    body: bytes


LinkNotice = (
    LinkStateChanged
    | EpochChanged
    | Resumed
    | SignalReceived
    | ReplyReceived
    | RequestFailed
    | ReadingReceived
    | Greeted
    | RequestReceived
)
