from random import Random

from onika.testing.weather import Weather


def test_half_of_all_weather_is_reliable_and_the_rest_loses_at_most_three_in_ten():
    drawn = [Weather.draw(Random(seed)) for seed in range(400)]
    assert 140 < sum(one.is_reliable for one in drawn) < 260
    assert max(one.loss for one in drawn) <= 0.3
    assert {one.delay_ns for one in drawn} == {1_000_000, 20_000_000, 80_000_000}


def test_the_same_seed_draws_the_same_weather():
    assert Weather.draw(Random(3)) == Weather.draw(Random(3))
