from kit.labs.library_site import TODAY, wink
from onika.files.library_index import LibraryIndex, indexed_text
from onika.files.library_lock import Agreement
from onika.store.remote.agreement import agreement_of, declared, further, stays_within


def test_what_a_task_writes_is_said_by_the_names_that_it_uses():  # R-X16
    text = wink("LAMP", "Q^_REF").replace("INCONST", "SVARALIAS   LAMP=LIGHT\nINCONST", 1)
    assert agreement_of("wink", text.encode()) == Agreement(frozenset({"LIGHT", "Q^_REF"}))


def test_the_devices_of_a_task_are_what_it_touches():  # R-X16
    text = wink().replace("EOF", "LOCAL\nDEVICE      boxes:arm\nEOF")
    assert agreement_of("wink", text.encode()) == Agreement(frozenset({"LAMP"}), frozenset({"boxes:arm"}))


def test_a_file_at_fault_says_nothing():  # R-X16
    assert agreement_of("wink", b"MODULE") is None
    assert agreement_of("wink", b"\xff") is None


def test_every_task_of_an_index_is_looked_at():  # R-X16
    texts = {"module/wink.rmod": wink(), "module/wrong.rmod": "x", "conf/wink.rmod.conf": ""}
    files = {path: indexed_text(path, text.encode()) for path, text in texts.items()}
    index = LibraryIndex("wings", 1, TODAY, TODAY, files=files)
    assert declared(index) == {"wink": Agreement(frozenset({"LAMP"}))}


def test_only_what_goes_further_is_new():  # R-X16
    before = {"a": Agreement(frozenset({"X", "Y"})), "b": Agreement()}
    now = {
        "a": Agreement(frozenset({"X"})),
        "b": Agreement(frozenset({"Z"})),
        "c": Agreement(touches=frozenset({"d:e"})),
    }
    assert further(before, now) == {"b": now["b"], "c": now["c"]}


def test_a_quick_look_never_passes_what_a_reader_would_refuse():  # R-X16
    texts = [wink(*outputs) for outputs in (("A",), ("A", "B"))]
    texts += [text.replace("INCONST", "SVARALIAS   A=C\nINCONST", 1) for text in texts]
    texts += [text.replace("EOF", "LOCAL\nDEVICE      boxes:arm\nEOF") for text in texts]
    for text in texts:
        agreement = agreement_of("wink", text.encode())
        assert agreement is not None
        assert stays_within(text.encode(), agreement)
        for name in agreement.writes:
            assert not stays_within(text.encode(), Agreement(agreement.writes - {name}, agreement.touches))
        for name in agreement.touches:
            assert not stays_within(text.encode(), Agreement(agreement.writes, agreement.touches - {name}))
