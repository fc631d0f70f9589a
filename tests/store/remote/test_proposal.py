from hashlib import sha256

from onika.store.remote.own_changes import OwnChange
from onika.store.remote.proposal import ProposedFile, proposed

OLD = b"a\nb\nc\n"


def hash_of(content):
    return sha256(content).hexdigest()


def change(content, base=OLD):
    return OwnChange("appl/x.appl", hash_of(base) if base else "", content, base or None)


def test_what_nobody_else_has_changed_is_sent_as_it_is():  # R-F03
    proposal = proposed([change(b"A\nb\nc\n")], {"appl/x.appl": OLD})
    assert proposal.files == (ProposedFile("appl/x.appl", hash_of(OLD), b"A\nb\nc\n", b"A\nb\nc\n"),)
    assert proposal.merged == ()


def test_what_others_have_changed_elsewhere_is_merged_onto_theirs():  # R-F03
    proposal = proposed([change(b"A\nb\nc\n")], {"appl/x.appl": b"a\nb\nC\n"})
    (file,) = proposal.merged
    assert (file.base, file.content, file.own) == (hash_of(b"a\nb\nC\n"), b"A\nb\nC\n", b"A\nb\nc\n")


def test_what_was_removed_is_no_text_or_has_no_beginning_contradicts():  # R-F03
    for mine, theirs in ((change(b"A\n"), None), (change(b"\xff"), b"\xfe"), (change(b"A\n", b""), b"B\n")):
        proposal = proposed([mine], {"appl/x.appl": theirs})
        (conflict,) = proposal.contradictions
        assert (conflict.mine, conflict.theirs, conflict.marked) == (mine.content, theirs, None)
        (file,) = proposed([mine], {"appl/x.appl": theirs}, mine_counts=True).files
        assert file.content == mine.content and not file.is_merged


def test_what_is_there_already_is_not_sent():  # R-F03
    proposal = proposed([change(b"A\n")], {"appl/x.appl": b"A\n"})
    assert proposal.files == () and [file.path for file in proposal.same] == ["appl/x.appl"]
