"""The frequency response of a measurement to its reference, estimated from signals that are sampled evenly (C14, X05).

Of a signal that goes on (a sweep, noise) it is the mean of windowed stretches that overlap: H = Sxy / Sxx, where Sxy is
their cross spectrum and Sxx the power of the reference (Welch 1967). Of one step it is the spectrum of the differences
of the measurement over the height of the step. The page computes the same (`frequencyResponse.ts`).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from onika.words.reason import Reason

LEAST_SAMPLES = 64
LEAST_SEGMENT = 16
RELIABLE = 0.8
"""From this coherence on a frequency counts for readings."""

_UNMOVED = 1e-9
"""What changes less, as a part of its greatest value, does not change."""
_EXCITED = 1e-2
"""Frequencies with a smaller part of the greatest power of the reference are left out: what leaks there is noise."""
_OVERLAPPING = 4
"""So many stretches lie over each instant; the squares of their windows add up to the same everywhere."""
_AT_REST = 0.02
"""What moves by a smaller part of its whole way is at rest: at the ends, and after a step in the last twentieth."""


@dataclass(frozen=True, slots=True)
class FrequencyResponse:
    """At each frequency the complex gain from reference to measurement; frequencies rise, 0 is not among them."""

    hertz: NDArray[np.float64]
    gain: NDArray[np.complex128]
    coherence: NDArray[np.float64]
    """Which part of the measurement's power follows the reference, 0 to 1; of a step, which comes once, no number."""
    segments: int
    """How many stretches it is the mean of; 0: it is that of a step."""

    @property
    def is_of_step(self) -> bool:
        """Whether the reference was one step."""
        return self.segments == 0

    @property
    def decibels(self) -> NDArray[np.float64]:
        """The size of the gain in dB."""
        return 20.0 * np.log10(np.abs(self.gain))

    @property
    def is_reliable(self) -> NDArray[np.bool_]:
        """Which frequencies count for readings."""
        return np.isnan(self.coherence) | (self.coherence >= RELIABLE)

    @property
    def degrees(self) -> NDArray[np.float64]:
        """The phase in degrees, without jumps: each is within half a turn of the last reliable one before it."""
        phases = np.degrees(np.angle(self.gain))
        former = 0.0
        for place, is_reliable in enumerate(self.is_reliable):
            phases[place] -= 360.0 * np.round((phases[place] - former) / 360.0)
            if is_reliable:
                former = phases[place]
        return phases


def frequency_response(
    reference: NDArray[np.float64], measured: NDArray[np.float64], step_s: float, segment: int = 0
) -> FrequencyResponse:
    """The response of signals of one length, `step_s` apart; `segment` samples make a stretch (0: as fits the length).

    Raises ValueError with a reason where nothing can be estimated of them.
    """
    count = len(reference)
    if count < LEAST_SAMPLES:
        raise ValueError(Reason.of("record.response_short", count=count, least=LEAST_SAMPLES))
    strange = int(np.count_nonzero(~(np.isfinite(reference) & np.isfinite(measured))))
    if strange:
        raise ValueError(Reason.of("record.response_no_numbers", count=strange))
    if _is_constant(reference):
        raise ValueError(Reason.of("record.response_no_excitation"))
    if _is_constant(measured):
        raise ValueError(Reason.of("record.response_constant"))
    changes = np.flatnonzero(np.abs(np.diff(reference)) > _UNMOVED * np.ptp(reference))
    if len(changes) == 1:
        return _of_step(reference[changes[0] :], measured[changes[0] :], step_s)
    return _of_course(reference, measured, step_s, segment or 1 << (count // 4).bit_length() - 1)


def _is_constant(signal: NDArray[np.float64]) -> bool:
    return bool(np.ptp(signal) <= _UNMOVED * np.max(np.abs(signal)))


def _of_step(reference: NDArray[np.float64], measured: NDArray[np.float64], step_s: float) -> FrequencyResponse:
    """Of the one step, which lies between the first two samples: it has every frequency in it."""
    count = len(measured)
    if count < LEAST_SAMPLES:
        raise ValueError(Reason.of("record.response_short", count=count, least=LEAST_SAMPLES))
    twentieth = count // 20
    last, former = np.mean(measured[-twentieth:]), np.mean(measured[-2 * twentieth : -twentieth])
    if abs(last - former) > _AT_REST * np.ptp(measured):
        raise ValueError(Reason.of("record.response_moves"))
    spectrum = np.fft.rfft(np.diff(measured)) / (reference[1] - reference[0])
    hertz = np.fft.rfftfreq(count - 1, step_s).astype(np.float64)
    return _response(hertz, spectrum, np.full(len(hertz), np.nan), spectrum != 0.0, 0)


def _of_course(
    reference: NDArray[np.float64], measured: NDArray[np.float64], step_s: float, segment: int
) -> FrequencyResponse:
    """Of signals that go on: the mean over stretches, each less its own mean and under a Hann window."""
    longest = len(reference) // 2
    if not LEAST_SEGMENT <= segment <= longest:
        bounds = {"least": LEAST_SEGMENT * step_s, "most": longest * step_s}
        raise ValueError(Reason.of("record.response_segment", seconds=segment * step_s, **bounds))
    window = 0.5 - 0.5 * np.cos(2.0 * np.pi * np.arange(segment) / segment)
    power, answer, cross = np.zeros((3, segment // 2 + 1), dtype=np.complex128)
    hop = segment // _OVERLAPPING
    reference, measured = _padded(reference, measured, segment - hop)
    begins = range(0, len(reference) - segment + 1, hop)
    for begin in begins:
        x, y = (
            np.fft.rfft(window * (signal - np.mean(signal)))
            for signal in (reference[begin : begin + segment], measured[begin : begin + segment])
        )
        power += np.abs(x) ** 2
        answer += np.abs(y) ** 2
        cross += np.conj(x) * y
    is_excited = power.real > _EXCITED * np.max(power.real)
    is_excited[:2] = False  # what the window makes of the mean that was taken away
    is_known = is_excited & (cross != 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        coherence = np.abs(cross) ** 2 / (power.real * answer.real)
        gain = cross / power
    return _response(np.fft.rfftfreq(segment, step_s).astype(np.float64), gain, coherence, is_known, len(begins))


def _padded(
    reference: NDArray[np.float64], measured: NDArray[np.float64], width: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Both with so many samples before and after, so that the ends of a sweep weigh as much as its middle.

    Where both are at rest they keep their values; else they are given their means, which excite nothing by themselves.
    """
    signals = (reference, measured)
    few = max(len(reference) // 100, 4)
    begins_at_rest, ends_at_rest = (
        all(np.ptp(signal[end]) <= _AT_REST * np.ptp(signal) for signal in signals)
        for end in (slice(few), slice(-few, None))
    )
    wider = [
        np.pad(
            signal,
            width,
            constant_values=(
                signal[0] if begins_at_rest else np.mean(signal),
                signal[-1] if ends_at_rest else np.mean(signal),
            ),
        )
        for signal in signals
    ]
    return wider[0], wider[1]


def _response(
    hertz: NDArray[np.float64],
    gain: NDArray[np.complex128],
    coherence: NDArray[np.float64],
    is_known: NDArray[np.bool_],
    segments: int,
) -> FrequencyResponse:
    """What is known of it, above a standstill."""
    kept = is_known & (hertz > 0.0)
    if not kept.any():
        raise ValueError(Reason.of("record.response_no_excitation"))
    return FrequencyResponse(hertz[kept], gain[kept], np.minimum(coherence[kept], 1.0), segments)
