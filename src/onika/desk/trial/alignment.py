"""Aligns the actions of a run with those kept: the same, missing, new, or with another target (requirement X07)."""

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher


@dataclass(frozen=True, slots=True)
class Pair:
    """An action as it was kept and as it was done, by their places; None where there is none."""

    kept: int | None
    done: int | None


def align(kept: Sequence[str], done: Sequence[str]) -> list[Pair]:
    """All actions of both in order, those of one name paired; also those of one job that stand for each other."""
    pairs = []
    for tag, i, i_end, j, j_end in SequenceMatcher(None, kept, done, autojunk=False).get_opcodes():
        is_other = tag == "replace" and i_end - i == j_end - j
        is_other = is_other and all(job(a) == job(b) for a, b in zip(kept[i:i_end], done[j:j_end], strict=True))
        if tag == "equal" or is_other:
            pairs += [Pair(a, b) for a, b in zip(range(i, i_end), range(j, j_end), strict=True)]
        else:
            pairs += [Pair(a, None) for a in range(i, i_end)] + [Pair(None, b) for b in range(j, j_end)]
    return pairs


def job(action: str) -> str:
    """The job of an action `jmoveC home`."""
    return action.partition(" ")[0]
