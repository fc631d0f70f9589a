from contextlib import closing
from pathlib import Path
from threading import Barrier, BrokenBarrierError

import pytest

from kit.labs.library_server import LibraryServer, answer, piece
from onika.store.remote.address import WebAddress, web_address
from onika.store.remote.credential import Credential
from onika.store.remote.piece import FIRST
from onika.store.remote.source import Wanted
from onika.store.remote.web_source import CONNECTIONS, WebSource
from onika.words.reason import Reason

LONG = bytes(range(251)) * 200


def source(server: LibraryServer, credential: Credential | None = None) -> WebSource:
    address = web_address(server.address)
    assert isinstance(address, WebAddress)
    return WebSource(address, credential=credential)


def opened(server: LibraryServer, credential: Credential | None = None) -> WebSource:
    """With all connections open."""
    ours = source(server, credential)
    ours.expect_more()
    ours.expected()
    return ours


@pytest.fixture
def long_file(tmp_path):
    """A folder with a long file."""
    (tmp_path / "library").write_bytes(LONG)
    return tmp_path


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


def test_a_long_file_comes_in_pieces_over_all_connections(long_file):  # R-F03
    with LibraryServer(long_file, knows_pieces=True) as server:
        with closing(opened(server)) as ours:
            assert ours.fetch([Wanted("library", 100_000)]) == {"library": LONG}
        assert server.pieces[0] == (0, FIRST)
        assert len(server.pieces) == 1 + CONNECTIONS == len(server.asked)
        assert sum(end - begin for begin, end in server.pieces) == len(LONG)
        assert max(end - begin for begin, end in server.pieces) <= FIRST  # each of them is little for its connection


def test_a_wrong_password_counts_once_for_a_long_file(long_file):  # R-X16
    with LibraryServer(long_file, "right", knows_pieces=True) as server:
        with closing(opened(server, Credential("wrong"))) as ours:
            refused = ours.fetch([Wanted("library", 100_000)])
        assert isinstance(refused, Reason) and refused.key == "store.password_wrong"
        assert server.asked == ["library"]


def test_a_server_that_knows_no_pieces_is_asked_once(long_file):  # R-F03
    with LibraryServer(long_file) as server:
        with closing(opened(server)) as ours:
            assert ours.fetch([Wanted("library", 100_000)]) == {"library": LONG}
        assert server.asked == ["library"]


def test_a_file_that_was_changed_between_its_pieces_is_asked_for_as_a_whole(long_file):  # R-F03
    def changes(there):
        there.sendall(piece(LONG, 0, FIRST))
        del server.answers["library"]
        (long_file / "library").write_bytes(LONG[::-1])

    with LibraryServer(long_file, knows_pieces=True) as server:
        server.answers["library"] = changes
        with closing(opened(server)) as ours:
            assert ours.fetch([Wanted("library", 100_000)]) == {"library": LONG[::-1]}


def test_a_piece_of_more_than_was_signed_is_not_read(long_file):  # R-X16
    with LibraryServer(long_file, knows_pieces=True) as server, closing(opened(server)) as ours:
        answered = ours.fetch([Wanted("library", len(LONG) - 1)])
    assert isinstance(answered, Reason) and answered.key == "store.answer_large"


def test_another_piece_than_was_asked_for_is_none(long_file):  # R-X16
    with LibraryServer(long_file) as server:
        server.answers["library"] = lambda there: there.sendall(piece(LONG, 1, FIRST))
        with closing(opened(server)) as ours:
            answered = ours.fetch([Wanted("library", 100_000)])
    assert isinstance(answered, Reason) and answered.key == "store.server_garbled"


def test_a_line_that_breaks_between_the_pieces_is_said(long_file):  # R-X16
    with LibraryServer(long_file) as server:
        pieces = [piece(LONG, 0, FIRST), b""]
        server.answers["library"] = lambda there: there.sendall(pieces.pop(0)) if pieces[0] else there.shutdown(2)
        with closing(opened(server)) as ours:
            answered = ours.fetch([Wanted("library", 100_000)])
    assert isinstance(answered, Reason) and answered.key == "store.server_gone"
