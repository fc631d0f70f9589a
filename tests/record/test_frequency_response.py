import math

import numpy as np
import pytest

from onika.record.frequency_response import frequency_response
from onika.words.reason import reason_of

STEP_S = 0.002


def swept(count=15_000, first=0.5, last=20.0):
    """A linear sweep of a sine, with values that other programs compute alike."""
    at_s = np.arange(count) * STEP_S
    return np.sin(2 * np.pi * (first * at_s + (last - first) / (2 * count * STEP_S) * at_s**2))


def first_order(signal, hertz):
    """What y' = (x - y) / T makes of a held signal, and its gain at any frequency."""
    keep = math.exp(-2 * np.pi * hertz * STEP_S)
    answer = np.zeros(len(signal))
    for k in range(1, len(signal)):
        answer[k] = keep * answer[k - 1] + (1 - keep) * signal[k - 1]
    return answer, lambda z: (1 - keep) / (z - keep)


def second_order(signal, hertz, damping):
    """What a mass on a spring makes of a held signal, exactly from sample to sample, and its gain at any frequency."""
    omega = 2 * np.pi * hertz
    root = omega * math.sqrt(1 - damping**2)
    decay = math.exp(-damping * omega * STEP_S)
    cos, sin = math.cos(root * STEP_S), math.sin(root * STEP_S)
    share = damping * omega / root
    first, second = 2 * decay * cos, -(decay**2)
    now = 1 - decay * (cos + share * sin)
    former = decay**2 + decay * (share * sin - cos)
    answer = np.zeros(len(signal))
    answer[1] = now * signal[0]
    for k in range(2, len(signal)):
        answer[k] = first * answer[k - 1] + second * answer[k - 2] + now * signal[k - 1] + former * signal[k - 2]
    return answer, lambda z: (now * z + former) / (z * z - first * z - second)


def truth(gain, hertz):
    return gain(np.exp(2j * np.pi * hertz * STEP_S))


SYSTEMS = [lambda x: first_order(x, 3.0), lambda x: second_order(x, 4.0, 0.7), lambda x: second_order(x, 5.0, 0.3)]


@pytest.mark.parametrize("system", SYSTEMS)
def test_a_sweep_gives_gain_and_phase_of_a_system_that_is_known(system):  # R-C14
    reference = np.pad(swept(), 500)  # it rests for a second before and after
    measured, gain = system(reference)
    response = frequency_response(reference, measured, STEP_S)
    sure = (response.coherence > 0.99) & (response.hertz < 19.0)
    assert np.count_nonzero(sure) > 0.95 * np.count_nonzero(response.hertz < 19.0) > 65
    ratio = response.gain[sure] / truth(gain, response.hertz[sure])
    assert np.max(np.abs(20 * np.log10(np.abs(ratio)))) < 0.15
    assert np.max(np.abs(np.degrees(np.angle(ratio)))) < 1.0
    assert not response.is_of_step


@pytest.mark.parametrize("system", SYSTEMS)
def test_a_step_gives_the_same(system):  # R-C14
    reference = np.where(np.arange(5000) < 700, 0.2, -0.3)
    measured, gain = system(reference - 0.2)
    response = frequency_response(reference, measured + 7.0, STEP_S)
    ratio = response.gain / truth(gain, response.hertz)
    assert response.is_of_step
    assert np.isnan(response.coherence).all()
    assert np.max(np.abs(20 * np.log10(np.abs(ratio[response.hertz < 100])))) < 0.01
    assert np.max(np.abs(np.degrees(np.angle(ratio[response.hertz < 100])))) < 0.1


def test_noise_lowers_the_coherence_and_hardly_the_gain():  # R-C14
    random = np.random.default_rng(1)
    reference = random.normal(size=60_000)
    measured, gain = first_order(reference, 20.0)
    response = frequency_response(reference, measured + 0.2 * random.normal(size=60_000), STEP_S, 512)
    low, high = response.hertz < 20.0, response.hertz > 150.0
    assert np.mean(response.coherence[low]) > 0.9 > 0.5 > np.mean(response.coherence[high])
    assert abs(np.mean(20 * np.log10(np.abs(response.gain[low] / truth(gain, response.hertz[low]))))) < 0.1
    assert not response.is_reliable[high].all()


def test_what_has_nothing_to_do_with_the_reference_is_not_reliable():
    random = np.random.default_rng(2)
    reference, measured = random.normal(size=(2, 60_000))
    assert not frequency_response(reference, measured, STEP_S, 256).is_reliable.any()


def test_a_frequency_that_was_not_excited_is_left_out():
    response = frequency_response(swept(last=5.0), swept(last=5.0), STEP_S)
    assert response.hertz[-1] < 6.0
    assert response.hertz[0] > 0.0
    np.testing.assert_allclose(response.gain, 1.0, atol=1e-12)
    np.testing.assert_allclose(response.coherence, 1.0, atol=1e-12)


def test_the_phase_goes_on_beyond_half_a_turn():
    reference = swept()
    late = np.concatenate([np.zeros(100), reference[:-100]])  # 0.2 s: a turn every 5 Hz
    response = frequency_response(reference, late, STEP_S)
    sure = (response.hertz > 1.0) & (response.hertz < 18.0)
    assert np.max(np.abs(response.degrees[sure] + 360 * 0.2 * response.hertz[sure])) < 2.0
    assert response.degrees[sure][-1] < -1200.0


ON_THE_PAGE = [
    (1.953125, -0.5355024867809243, -42.7487618545275, 0.9475701355846824),
    (6.8359375, -9.674791608000168, -130.1218519320554, 0.9677713344583154),
    (11.71875, -15.637452000892909, -142.12413528109764, 0.9950498233619314),
]


def test_noise_is_told_at_low_frequencies_too():
    reference = np.random.default_rng(5).uniform(-1.0, 1.0, 3000)
    measured, _ = first_order(reference, 20.0)
    response = frequency_response(reference, measured, STEP_S)
    assert np.min(response.coherence[:10]) > 0.95


def test_a_sweep_between_two_places_of_rest_is_right_beyond_its_ends():
    reference = np.concatenate([np.zeros(1000), swept(12_000, 0.5, 10.0), np.zeros(2000)]) + 5.0
    measured, gain = second_order(reference - 5.0, 4.0, 0.3)
    response = frequency_response(reference, measured - 3.0, STEP_S)
    ratio = np.abs(response.gain / truth(gain, response.hertz))
    assert np.max(np.abs(20 * np.log10(ratio))) < 0.5


def test_the_page_finds_the_same_numbers():
    """`frequencyResponse.test.ts` has the same: both estimate alike, not only nearly."""
    reference = swept(4000, 0.5, 10.0)
    response = frequency_response(reference, second_order(reference, 4.0, 0.7)[0], STEP_S)
    assert (len(response.hertz), response.segments) == (11, 34)
    for place, numbers in zip((0, 5, 10), ON_THE_PAGE, strict=True):
        rows = (response.hertz, response.decibels, response.degrees, response.coherence)
        assert [row[place] for row in rows] == pytest.approx(numbers, rel=1e-9)


STILL = np.zeros(1000)
ENDLESS = np.where(np.arange(1000) == 7, math.inf, 0.0)
NAN = np.where(np.arange(1000) == 5, math.nan, swept(1000))
EARLY = np.where(np.arange(1000) < 950, 0.0, 1.0)
RAMP = np.arange(1000.0)
JUMP = np.where(np.arange(1000) < 100, 0.0, 1.0)


@pytest.mark.parametrize(
    ("reference", "measured", "segment", "key"),
    [
        (swept(50), swept(50), 0, "record.response_short"),
        (np.empty(0), np.empty(0), 0, "record.response_short"),
        (EARLY, swept(1000), 0, "record.response_short"),
        (STILL, swept(1000), 0, "record.response_no_excitation"),
        (STILL + 1e9, swept(1000), 0, "record.response_no_excitation"),
        (swept(1000), STILL + 3, 0, "record.response_constant"),
        (NAN, swept(1000), 0, "record.response_no_numbers"),
        (swept(1000), ENDLESS, 0, "record.response_no_numbers"),
        (JUMP, RAMP, 0, "record.response_moves"),
        (swept(1000), swept(1000), 501, "record.response_segment"),
        (swept(1000), swept(1000), 15, "record.response_segment"),
    ],
)
def test_of_what_nothing_can_be_estimated_it_is_said_why(reference, measured, segment, key):  # R-E01
    with pytest.raises(ValueError) as refusal:
        frequency_response(reference, measured, STEP_S, segment)
    assert reason_of(refusal.value).key == key
