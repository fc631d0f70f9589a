from contextlib import closing
from pathlib import Path
from threading import Barrier, BrokenBarrierError

from kit.labs.library_server import LibraryServer, answer
from onika.store.remote.address import WebAddress, web_address
from onika.store.remote.source import Wanted
from onika.store.remote.web_source import CONNECTIONS, WebSource
from onika.words.reason import Reason


def source(server: LibraryServer) -> WebSource:
    address = web_address(server.address)
    assert isinstance(address, WebAddress)
    return WebSource(address)


def test_many_files_come_over_six_connections_at_once(tmp_path: Path):  # R-F03
    names = [f"file{number}" for number in range(12)]
    together = Barrier(CONNECTIONS)  # passes only where six questions are under way at a time

    def meet(there):
        try:
            together.wait(5)
        except BrokenBarrierError:
            return
        there.sendall(answer(b"content"))

    with LibraryServer(tmp_path) as server:
        for name in names:
            server.answers[name] = meet
        with closing(source(server)) as ours:
            files = ours.fetch([Wanted(name, 100) for name in names])
        assert files == dict.fromkeys(names, b"content")
        assert server.connections == CONNECTIONS


def test_connections_are_opened_while_the_index_comes(tmp_path):  # R-F03
    (tmp_path / "library").write_bytes(b"an index")
    with LibraryServer(tmp_path) as server:
        with closing(source(server)) as ours:
            ours.expect_more()
            assert ours.fetch([Wanted("library", 100)]) == {"library": b"an index"}
            server.answers.update({f"file{number}": lambda there: there.sendall(answer(b"x")) for number in range(6)})
            ours.fetch([Wanted(f"file{number}", 100) for number in range(6)])
        assert server.connections == CONNECTIONS


def test_at_the_first_file_that_does_not_come_nothing_more_is_asked_for(tmp_path):  # R-X16
    with LibraryServer(tmp_path) as server:
        with closing(source(server)) as ours:
            answered = ours.fetch([Wanted(f"file{number}", 100) for number in range(1000)])
        assert isinstance(answered, Reason) and answered.key == "store.not_on_server"
        assert len(server.asked) < 50
