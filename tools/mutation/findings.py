"""The findings of one trial: how many mutants there were, which of them no test notices, what no test carries out."""

from dataclasses import dataclass, field


@dataclass(slots=True)
class Findings:
    """Of one file.

    survivors    the names of mutants with which all tests pass
    missing      lines and branches that no test carries out
    failure      why there could be no trial: a test that does not even pass on the file as it is
    """

    path: str
    mutants: int = 0
    survivors: list[str] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    failure: str = ""
    seconds: float = 0.0
