"""What a sweep varies: a number of a task, drawn anew for each run from a range or from a list (requirement X23).

    variation = Variation.parse("pd.STIFF=100..300")
    variation.draw(seed=17)

What is drawn follows from the seed and the name alone, whatever else is varied.
"""

import math
from dataclasses import dataclass
from random import Random

from onika.desk.plan.varied import LocalAddress
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Variation:
    """A name, and the range or the list of which its values are."""

    name: str
    least: float = 0.0
    most: float = 0.0
    choices: tuple[float, ...] = ()

    @classmethod
    def parse(cls, text: str) -> "Variation":
        """`NAME=FROM..TO` or `NAME=A,B,C`; raises ValueError that says what was expected."""
        name, equals, values = text.partition("=")
        if not equals:
            raise ValueError(Reason.of("sweep.variation", text=text))
        address = str(LocalAddress.parse(name))
        least, dots, most = values.partition("..")
        if not dots:
            return cls(address, choices=tuple(_number(word, text) for word in values.split(",")))
        bounds = _number(least, text), _number(most, text)
        if bounds[0] > bounds[1]:
            raise ValueError(Reason.of("sweep.reversed", text=text))
        return cls(address, *bounds)

    def draw(self, seed: int) -> float:
        """The value for the run of a seed."""
        chance = Random(f"{self.name} {seed}")  # noqa: S311 - it has to be the same again
        return chance.choice(self.choices) if self.choices else chance.uniform(self.least, self.most)

    @property
    def text(self) -> str:
        """As it is written."""
        if self.choices:
            return f"{self.name}={','.join(f'{choice:.15g}' for choice in self.choices)}"
        return f"{self.name}={self.least:.15g}..{self.most:.15g}"


def _number(word: str, text: str) -> float:
    try:
        number = float(word)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(Reason.of("sweep.variation", text=text))
    return number
