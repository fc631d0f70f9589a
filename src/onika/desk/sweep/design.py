"""The design of a sweep: what is run, how often, and what is varied (requirement X23)."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from onika.desk.run.settings import RunSettings
from onika.desk.sweep.case import Case
from onika.desk.sweep.variation import Variation


@dataclass(frozen=True, slots=True)
class SweepDesign:
    """An application, a run for each seed, each with numbers of its own."""

    settings: RunSettings
    seeds: range
    variations: tuple[Variation, ...] = ()
    is_shaken: bool = True
    """Whether the things of the worlds stand a little elsewhere in each run."""

    def cases(self) -> Iterator[Case]:
        """The runs, in the order of their seeds."""
        for seed in self.seeds:
            yield Case(seed, {variation.name: variation.draw(seed) for variation in self.variations})

    def settings_of(self, case: Case) -> RunSettings:
        """What a run of this case is to be; by itself it is the same run bit for bit."""
        shake = case.seed if self.is_shaken else None
        return replace(self.settings, seed=case.seed, shake=shake, values=tuple(case.values.items()))

    @property
    def command(self) -> tuple[str, ...]:
        """The words that say all of it but the seeds, as they stand in the file of results."""
        settings = self.settings
        words = [settings.name, *(f"--vary {variation.text}" for variation in self.variations)]
        words += [f"--expect {expectation.text}" for expectation in settings.expectations]
        words += [f"--redirect {redirect}" for redirect in settings.redirects]
        words += [f"--answer {task}.{name}={values}" for task, name, values in settings.answers]
        words += [f"--settle {settings.settle_s:g}"] if settings.expectations else []
        return (*words, *([] if self.is_shaken else ["--no-shake"]))
