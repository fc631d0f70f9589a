import json

import catalogues
from onika.words.catalogue import sentence


def test_the_page_is_given_every_sentence_of_a_language():
    line = f'  "cli.language_option": {json.dumps(sentence("es", "cli.language_option"), ensure_ascii=False)},'
    assert line in catalogues.source("es").splitlines()
