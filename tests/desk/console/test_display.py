from onika.desk.console.display import Tone


def test_every_tone_has_a_name_of_its_own():
    assert len({tone.value for tone in Tone}) == len(Tone)
