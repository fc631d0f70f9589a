"""The accepted language: which of our languages somebody who asks over HTTP reads best."""

from collections.abc import Iterator

from onika.words.sentence import LANGUAGES


def accepted_language(header: str) -> str:
    """The language of ours that an `Accept-Language` puts first; English where it names none of them."""
    weights: dict[str, float] = {}
    for language, weight in _weights(header):
        weights.setdefault(language, weight)
    accepted = [language for language, weight in weights.items() if language in LANGUAGES and weight > 0.0]
    return max(accepted, key=weights.__getitem__, default=LANGUAGES[0])


def _weights(header: str) -> Iterator[tuple[str, float]]:
    """Each language in its order, with how much it is wanted, from 0 to 1."""
    for item in header.lower().split(","):
        tag, _, parameter = item.partition(";")
        language = tag.strip().partition("-")[0]
        yield language, _weight(parameter.strip())


def _weight(parameter: str) -> float:
    """What `q=0.5` says: 1 where nothing is said, 0 where it is no weight."""
    if not parameter:
        return 1.0
    name, _, number = parameter.partition("=")
    try:
        weight = float(number)
    except ValueError:
        return 0.0
    is_weight = name.strip() == "q" and 0.0 <= weight <= 1.0
    return weight if is_weight else 0.0
