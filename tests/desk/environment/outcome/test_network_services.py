from onika.desk.environment.outcome.network_services import NetworkServices
from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.fabric.phone_book import PhoneBook


def test_its_worker_asks_the_users_own_book(tmp_path):  # R-F06
    done = []
    services = NetworkServices(BackgroundWorker(done.append), PhoneBook(tmp_path))
    assert services.book.add_place("lan") is None
    services.worker.close()
    services.worker.tell(lambda model: model)
    assert done == []
