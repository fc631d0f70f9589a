from onika.link.link_quality import LinkQuality
from onika.wire.packet import Beat


def test_only_datagrams_count_and_the_last_one_tells_the_way():  # R-X12
    link_quality = LinkQuality().after(Beat(1, 5), 10)
    assert link_quality == LinkQuality()
    link_quality = link_quality.after(Beat(1, 0, 900), 20).after(Beat(2, 0, 100), 30).after(Beat(9, 5), 40)
    assert (link_quality.beats, link_quality.last_ns, link_quality.round_trip_us) == (2, 30, 100)
