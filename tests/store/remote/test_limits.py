from onika.files.library_index import LARGEST_FILE
from onika.store.remote.limits import Limits


def test_a_server_may_send_what_an_index_may_name_and_has_a_minute_for_it():  # R-F03
    limits = Limits()
    assert limits.file_bytes == LARGEST_FILE
    assert limits.connect_s < limits.idle_s < limits.total_s == 60.0
