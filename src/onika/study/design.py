"""A balanced order of subjects: in every so many subjects each variant comes once, at random (§6.2.1; H03).

These are permuted blocks: after each whole block the groups are equal, and never do they differ by more than one.
"""

import random
from collections.abc import Iterator, Sequence


def order(variants: Sequence[str], subjects: int, seed: int) -> list[tuple[str, str]]:
    """Names of subjects with the variant of each, in the order in which they come."""
    width = len(str(subjects))
    dealt = zip(range(1, subjects + 1), _dealt(variants, seed), strict=False)
    return [(f"s{number:0{width}}", variant) for number, variant in dealt]


def _dealt(variants: Sequence[str], seed: int) -> Iterator[str]:
    """Variants without end; the same from every version of Python, which promises that of its random numbers."""
    chance = random.Random(seed)  # noqa: S311 - nobody has to be kept from guessing it
    while True:
        drawn = [(chance.random(), number) for number in range(len(variants))]
        yield from (variants[number] for _, number in sorted(drawn))
