import os

import pytest

from onika.host.loading.loader_start import start_loader

pytestmark = pytest.mark.site


def test_a_loader_that_is_not_wanted_any_more_is_ended():  # law 21
    loader = start_loader()
    assert os.getpgid(loader.process.pid) == loader.process.pid  # what ends its group ends nobody else
    loader.end()
    assert loader.process.returncode is not None
