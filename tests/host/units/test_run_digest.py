from kit.worlds.mass_world import MassWorld
from onika.host.units.run_digest import Digest
from onika.runtime import news

MS = 1_000_000
WORD = news.Initialised("flow0", "pd")


class Looked(MassWorld):
    """A world that counts how often it is looked at."""

    times = 0

    def fingerprint(self):
        self.times += 1
        return super().fingerprint()


def test_equal_runs_have_equal_digests():  # R-X08, law 14
    first, other = Digest(), Digest()
    for digest in (first, other):
        digest.look(0, [MassWorld()])
        digest.hear(WORD)
    assert first.hexdigest() == other.hexdigest() != Digest().hexdigest()


def test_the_worlds_are_looked_at_every_50_ms_from_the_beginning_of_the_run():  # law 15
    digest, world = Digest(1000 * MS), Looked()
    for now in range(1000, 1102, 2):
        digest.look(now * MS, [world])
    assert world.times == 3


def test_every_word_counts():  # law 15
    once, twice = Digest(), Digest()
    for digest in (once, twice, twice):
        digest.hear(WORD)
    assert once.hexdigest() != twice.hexdigest()


def test_a_new_digest_knows_of_nobody_outside():  # law 15
    assert Digest().outside == set()
