"""The reply log: what became of each client's requests, so that a repeated request is carried out once."""

from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class StoredReply:
    """What was answered; late: refused because its deadline had passed."""

    body: bytes
    late: bool = False


@dataclass(slots=True, eq=False)
class ClientReplies:
    """One client's requests: those under way, those answered but perhaps not received; all below `settled` are over."""

    client: str
    settled: int = 1
    under_way: set[int] = field(default_factory=set)
    answers: dict[int, StoredReply] = field(default_factory=dict)

    def settle(self, done_below: int) -> None:
        """The client has what it wants of all numbers below this one."""
        if done_below > self.settled:
            self.settled = done_below
            self.answers = {number: answer for number, answer in self.answers.items() if number >= done_below}

    def is_new(self, number: int) -> bool:
        """Whether this request was never seen."""
        return number >= self.settled and number not in self.under_way and number not in self.answers

    def answer(self, number: int, answer: StoredReply) -> bool:
        """Note the answer; False when the client does not want it any more."""
        self.under_way.discard(number)
        if number < self.settled:
            return False
        self.answers[number] = answer
        return True


class ReplyLog:
    """The replies of the latest clients; the one that has been away longest is forgotten first."""

    def __init__(self, keep: int = 64) -> None:
        self._keep = keep
        self._client_replies: dict[str, ClientReplies] = {}

    def find(self, client: str) -> ClientReplies | None:
        """The replies of a client that is known."""
        return self._client_replies.get(client)

    def begin(self, client: str) -> ClientReplies:
        """A new, empty log for a client, in place of any it had."""
        self._client_replies.pop(client, None)
        while len(self._client_replies) >= self._keep:
            del self._client_replies[next(iter(self._client_replies))]
        self._client_replies[client] = client_replies = ClientReplies(client)
        return client_replies

    def renew(self, client: str) -> None:
        """The client is here again: it becomes the last to be forgotten."""
        self._client_replies[client] = self._client_replies.pop(client)

    def close(self, client: str) -> None:
        """The client said good-bye and will not ask again."""
        self._client_replies.pop(client, None)
