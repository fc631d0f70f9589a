import json
import runpy
from pathlib import Path

from onika.words.catalogue import sentence

TOOL = runpy.run_path(str(Path(__file__).parents[2] / "tools" / "catalogues.py"))


def test_the_page_is_given_every_sentence_of_a_language():
    line = f'  "cli.language_option": {json.dumps(sentence("es", "cli.language_option"), ensure_ascii=False)},'
    assert line in TOOL["source"]("es").splitlines()
