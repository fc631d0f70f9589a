from onika.host.processes.process_socket import ProcessSocket
from onika.host.units import pose_stream
from onika.host.units.device_messages import decode_word
from onika.host.units.pose_stream import PoseStream

MS = 1_000_000


def words_at(post):
    words = []
    while not post.is_closed and (received := post.receive()) is not None:
        words.append(decode_word(received[0]))
    return words


def test_everybody_who_asked_is_told_thirty_times_a_second():  # law 29
    stream = PoseStream("yard")
    assert not stream.is_due(0)
    posts = [ProcessSocket.pair() for _ in range(2)]
    for near, _ in posts:
        stream.add(near)
        stream.add(near)
    for now in range(0, 100 * MS, 2 * MS):
        if stream.is_due(now):
            stream.tell(now, now - 7, b"rows", ("lamp",))
    for _, end in posts:
        far = ProcessSocket(end)
        poses = words_at(far)
        far.close()
        assert [(each.world, each.at_ns, each.rows, each.lit, each.left_out) for each in poses] == [
            ("yard", at * MS - 7, b"rows", ("lamp",), 0) for at in (0, 34, 68)
        ]
        assert [each.told_ns for each in poses] == sorted(each.told_ns for each in poses)
    stream.close()
    assert not stream.is_due(10**12)


def test_who_is_gone_is_told_nothing_more():
    stream = PoseStream("yard")
    near, far = ProcessSocket.pair()
    stream.add(near)
    far.close()
    stream.tell(0, 0, b"", ())
    assert not stream.is_due(10**12)


def test_who_does_not_come_to_take_them_is_told_how_many_were_left_out(monkeypatch):  # bounded, and told
    monkeypatch.setattr(pose_stream, "_MOST_WAITING", 0)
    stream = PoseStream("yard")
    near, end = ProcessSocket.pair()
    far = ProcessSocket(end)
    stream.add(near)
    stream.tell(0, 0, b"", ())
    stream.tell(1, 1, b"", ())
    monkeypatch.undo()
    stream.tell(2, 2, b"", ())
    stream.tell(3, 3, b"", ())
    assert [(each.at_ns, each.left_out) for each in words_at(far)] == [(2, 2), (3, 0)]
    near.close()
    far.close()
