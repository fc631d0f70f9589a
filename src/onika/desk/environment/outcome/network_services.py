"""What acts on other sites need of the outside."""

from dataclasses import dataclass

from onika.desk.environment.outcome.worker import BackgroundWorker
from onika.fabric.phone_book import PhoneBook


@dataclass(frozen=True, slots=True)
class NetworkServices:
    """Used by acts.

    worker  may wait for places; all of it is done there, one thing after the other
    book    the user's own
    """

    worker: BackgroundWorker
    book: PhoneBook
