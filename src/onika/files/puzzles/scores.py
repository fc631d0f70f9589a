"""How far the user of this machine is with puzzles: the best result of each, and how often it was tried (G10)."""

from collections.abc import Mapping
from pathlib import Path

from msgspec import DecodeError, Struct, ValidationError, json, structs

from onika.files import whole
from onika.words.fault import Refusal

_LARGEST = 1 << 20


class PuzzleScore(Struct, frozen=True):
    """Of one puzzle; no stars: it was not solved yet."""

    tries: int = 0
    stars: int = 0
    actions: int = 0
    took_s: float = 0.0

    def after(self, stars: int, actions: int, took_s: float) -> "PuzzleScore":
        """With one more try; the better result stays: more stars, then fewer actions, then less time."""
        tried = structs.replace(self, tries=self.tries + 1)
        is_better = stars > 0 and (-stars, actions, took_s) < (-self.stars, self.actions, self.took_s)
        return structs.replace(tried, stars=stars, actions=actions, took_s=took_s) if is_better else tried


_decoder = json.Decoder(dict[str, PuzzleScore])


class PuzzleScores:
    """The scores in a file, by the names of puzzles."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def all(self) -> Mapping[str, PuzzleScore]:
        """Every score; a file that cannot be read has none."""
        try:
            with self._path.open("rb") as file:
                return _decoder.decode(file.read(_LARGEST))
        except (OSError, DecodeError, ValidationError):
            return {}

    def note(self, puzzle: str, stars: int, actions: int, took_s: float) -> Refusal | None:
        """One more try has ended, with so many stars; or why it cannot be written down."""
        scores = dict(self.all())
        scores[puzzle] = scores.get(puzzle, PuzzleScore()).after(stars, actions, took_s)
        saved = whole.write(self._path, json.encode(scores).decode() + "\n", whole.ANYTHING)
        return saved if isinstance(saved, Refusal) else None
