from onika.web.environment_options import EnvironmentOptions


def test_what_was_asked_for_goes_before_what_the_system_says():  # R-G05
    settings = EnvironmentOptions(is_upper_only=True, presentation="words").settings(
        {"ONIKA_LOWER": "yes", "LANG": "es"}
    )
    assert settings == {"ONIKA_LOWER": "no", "ONIKA_PRESENTATION": "words", "LANG": "es"}


def test_what_was_not_asked_for_stays_as_the_system_says_it():
    assert EnvironmentOptions().settings({"ONIKA_LOWER": "yes"}) == {"ONIKA_LOWER": "yes"}
