"""Catalogues of modules."""

from onika.store.base_directory import BaseDirectory
from onika.store.module_catalogue import merged, read, reopen_catalogues, translations_of
from onika.words.module_sentence import of_module, of_sentence
from onika.words.reason import in_language

SENTENCE = "joint {joint} is beyond {limit:.1f}"


def test_a_module_speaks_the_language_of_the_catalogue_beside_its_code(tmp_path):
    folder = tmp_path / "module"
    folder.mkdir()
    (folder / "reach.py").write_text("")
    (folder / "reach.es.toml").write_text(
        f'"{SENTENCE}" = "articulación {{joint}}: más de {{limit:.1f}}"\n"{{x}}" = "{{y"\n'
    )
    reason = of_module(of_sentence(SENTENCE, {"joint": 3, "limit": 2.14}), "reach")
    translations = translations_of([BaseDirectory(tmp_path)], "es")
    assert in_language(reason, "es", translations) == "articulación 3: más de 2,1"
    assert in_language(reason, "es") == in_language(reason, "en", translations) == "joint 3 is beyond 2.1"


def test_a_sentence_without_arguments_is_translated_as_it_is():
    translations = {"module:door:open {now}": "abierta {ahora}"}
    assert in_language(of_module(of_sentence("open {now}", {}), "door"), "es", translations) == "abierta {ahora}"


def test_a_catalogue_that_is_no_toml_or_whose_gaps_differ_is_at_fault():
    assert [fault.reason.key for fault in read("nonsense", "a.es.toml")[1]] == ["store.not_toml"]
    translations, faults = read('"{a}" = "{b}"\n"sound" = "sano"\n"number" = 5\n', "a.es.toml")
    assert translations == {"sound": "sano"}
    assert [fault.reason.args["sentence"] for fault in faults] == ["{a}", "number"]


def test_of_open_catalogues_only_what_was_written_is_read_again(tmp_path):
    folder = tmp_path / "module"
    folder.mkdir()
    for name in ("door", "lamp"):
        (folder / f"{name}.py").write_text("")
        (folder / f"{name}.es.toml").write_text('"on" = "conectada"\n')
    (folder / "nobody.es.toml").write_text('"on" = "conectada"\n')
    base = BaseDirectory(tmp_path)
    opened = reopen_catalogues(base, {}, frozenset())
    assert opened == {name: {"es": {"on": "conectada"}} for name in ("door", "lamp")}
    for name in ("door", "lamp"):
        (folder / f"{name}.es.toml").write_text('"on" = "encendida"\n')
    again = reopen_catalogues(base, opened, {folder / "lamp.es.toml"})
    assert again["door"] is opened["door"]
    assert again["lamp"] == {"es": {"on": "encendida"}}
    (folder / "lamp.es.toml").unlink()
    assert reopen_catalogues(base, again, frozenset()).keys() == {"door"}


def test_of_a_sentence_that_two_catalogues_of_a_module_have_the_first_translation_counts():
    first, second = {"lamp": {"es": {"on": "a"}}}, {"lamp": {"es": {"on": "b", "off": "c"}}, "door": {"es": {}}}
    assert merged([first, second]) == {"lamp": {"es": {"on": "a", "off": "c"}}, "door": {"es": {}}}
