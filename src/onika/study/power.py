"""How many subjects a comparison needs: the power of a one-way analysis of variance (H03).

Cohen's f is the standard deviation of the groups' means by that within them; 0.1 is called small, 0.25 medium, 0.4
large (Cohen, Statistical Power Analysis, 1988). F is noncentral with λ = f² N.
"""

from scipy import stats

ALPHA = 0.05
POWER = 0.8
_MOST = 1_000_000
SIZES = (0.1, 0.25, 0.4)


def power(f: float, groups: int, each: int, alpha: float = ALPHA) -> float:
    """The probability that a difference of this size is found, with `each` subjects in each group."""
    between, within = groups - 1, groups * (each - 1)
    limit = stats.f.ppf(1.0 - alpha, between, within)
    return float(stats.ncf.sf(limit, between, within, f * f * groups * each))


def subjects_needed(f: float, groups: int, wanted: float = POWER, alpha: float = ALPHA) -> int | None:
    """How many subjects each group needs so that the power is at least `wanted`; None: more than a million."""
    low, high = 1, 2
    while power(f, groups, high, alpha) < wanted:
        low, high = high, 2 * high
        if high > _MOST:
            return None
    while high - low > 1:
        middle = (low + high) // 2
        if power(f, groups, middle, alpha) >= wanted:
            high = middle
        else:
            low = middle
    return high
