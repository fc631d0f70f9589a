"""What is read off a frequency response: bandwidth, peak, and how far a loop is from swinging (C14, X05).

The page reads the same off it (`responseReadings.ts`).
"""

from dataclasses import dataclass
from math import nan

import numpy as np
from numpy.typing import NDArray

from onika.record.frequency_response import FrequencyResponse

FALLEN_DB = 20.0 * np.log10(2.0) / 2.0
"""By so much the gain has fallen at the bandwidth: to half the power."""


@dataclass(frozen=True, slots=True)
class ResponseReadings:
    """Frequencies in Hz, gains in dB, angles in degrees; no number where there is none among reliable frequencies."""

    low_db: float
    """The gain at the lowest frequency."""
    bandwidth_hz: float
    """Where the gain has first fallen by 3 dB from there."""
    peak_db: float
    """By how much the greatest gain is above the gain at the lowest frequency."""
    peak_hz: float
    phase_margin: float
    """180 degrees and the phase of the open loop where its gain falls through 1."""
    phase_margin_hz: float
    gain_margin_db: float
    """By how much the gain of the open loop is below 1 where its phase goes through -180 degrees."""
    gain_margin_hz: float


def readings(response: FrequencyResponse, is_open: bool = False) -> ResponseReadings:
    """Margins are those of the open loop: it is the response itself, or H / (1 - H) where its loop was closed by 1."""
    is_reliable = response.is_reliable
    hertz, gain, decibels = response.hertz[is_reliable], response.gain[is_reliable], response.decibels[is_reliable]
    if not len(hertz):
        return ResponseReadings(*[nan] * 8)
    peak = int(np.argmax(decibels))
    with np.errstate(divide="ignore", invalid="ignore"):
        loop = gain if is_open else gain / (1.0 - gain)
        size = 20.0 * np.log10(np.abs(loop))
    low = float(decibels[0])
    return ResponseReadings(
        low,
        _between(hertz, *_fall(decibels, low - FALLEN_DB)),
        float(decibels[peak]) - low,
        float(hertz[peak]),
        *_phase_margin(hertz, loop, size),
        *_gain_margin(hertz, loop, size),
    )


def _fall(values: NDArray[np.float64], level: float) -> tuple[int, float]:
    """After which place they first fall through a level, and at which part of the way to the next one; -1: nowhere."""
    places = np.flatnonzero((values[:-1] >= level) & (values[1:] < level))
    if not len(places):
        return -1, nan
    place = int(places[0])
    return place, float((values[place] - level) / (values[place] - values[place + 1]))


def _between(hertz: NDArray[np.float64], place: int, part: float) -> float:
    """The frequency there, as a logarithmic axis parts them."""
    return nan if place < 0 else float(hertz[place] * (hertz[place + 1] / hertz[place]) ** part)


def _phase_margin(
    hertz: NDArray[np.float64], loop: NDArray[np.complex128], size: NDArray[np.float64]
) -> tuple[float, float]:
    place, part = _fall(size, 0.0)
    if place < 0:
        return nan, nan
    turned = np.angle(-loop[place]) + part * np.angle(loop[place + 1] / loop[place])
    return float((np.degrees(turned) + 180.0) % 360.0 - 180.0), _between(hertz, place, part)


def _gain_margin(
    hertz: NDArray[np.float64], loop: NDArray[np.complex128], size: NDArray[np.float64]
) -> tuple[float, float]:
    """The phase goes through -180 degrees where the loop crosses the negative real axis from below."""
    before, after = loop[:-1], loop[1:]
    places = np.flatnonzero((before.imag < 0.0) & (after.imag >= 0.0) & (before.real < 0.0) & (after.real < 0.0))
    if not len(places):
        return nan, nan
    place = int(places[0])
    part = float(before[place].imag / (before[place].imag - after[place].imag))
    return float(-(size[place] + part * (size[place + 1] - size[place]))), _between(hertz, place, part)
