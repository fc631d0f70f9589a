"""A stream of tokens: the rest of a statement of AL while it is read from left to right.

What does not fit raises ValueError whose text is "expected …, found …"; whoever reads the statement reports it.
"""

from collections.abc import Sequence

from onika.files.al.logical_line import Statement, Token, joined
from onika.files.line import show
from onika.words.condition import Condition
from onika.words.name import TASK_NAME
from onika.words.reason import Reason


class TokenStream:
    """The tokens of a sentence and how far it is read."""

    def __init__(self, sentence: Statement, at: int = 0) -> None:
        self._tokens = sentence.tokens
        self._at = at

    @property
    def is_over(self) -> bool:
        """Whether nothing is left."""
        return self._at >= len(self._tokens)

    @property
    def left(self) -> Sequence[Token]:
        """What is not yet read."""
        return self._tokens[self._at :]

    def takes(self, *words: str) -> str:
        """Read the next word if it is one of these; gives it, else an empty text."""
        if self.is_over or not self._tokens[self._at].says(*words):
            return ""
        self._at += 1
        return self._tokens[self._at - 1].value

    def token(self, meaning: Reason, *kinds: str) -> Token:
        """The next token, of one of these kinds."""
        if self.is_over or self._tokens[self._at].kind not in kinds:
            raise ValueError(Reason.of("files.meaning_expected", meaning=meaning, rest=self.rest()))
        self._at += 1
        return self._tokens[self._at - 1]

    def name(self, meaning: Reason, keywords: frozenset[str]) -> str:
        """The name of an icon; one of the `keywords` must stand in quotes."""
        token = self.token(meaning, "word", "text")
        if (token.kind == "word" and token.value in keywords) or not TASK_NAME.match(token.value):
            raise ValueError(Reason.of("files.meaning_expected_token", meaning=meaning, token=show(str(token))))
        return token.value

    def tag(self) -> str:
        """A tag: one word, or a quoted text without blanks."""
        tag = self.token(Reason.of("files.a_tag"), "word", "text").value
        if not tag or " " in tag or "\t" in tag:
            raise ValueError(Reason.of("files.tag_of_one_word", given=show(tag)))
        return tag

    def variant(self, default: int = 1) -> int:
        """The number of `#2`; `default` where there is none."""
        is_there = not self.is_over and self._tokens[self._at].kind == "variant"
        if is_there:
            return int(self.token(Reason.of("files.a_variant"), "variant").value[1:])
        return default

    def condition(self, end: str = "") -> str:
        """The condition that the rest of the sentence is, but for the word `end` after it, if one is given."""
        rest = self.left
        if end:
            if not rest or not rest[-1].says(end):
                raise ValueError(Reason.of("files.behind_condition", end=end, rest=self.rest()))
            rest = rest[:-1]
        self._at = len(self._tokens)
        text = rest[0].value if len(rest) == 1 and rest[0].kind == "text" else joined(rest)
        Condition.parse(text)
        return text

    def end(self) -> None:
        """See that nothing is left."""
        if not self.is_over:
            raise ValueError(Reason.of("files.end_of_line", rest=self.rest()))

    def rest(self) -> Reason | str:
        """What is left, for a message."""
        if self.left:
            return show(joined(self.left))
        return Reason.of("files.line_end")
