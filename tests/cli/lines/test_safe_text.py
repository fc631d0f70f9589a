from onika.cli.lines.safe_text import safe


def test_what_a_module_says_commands_no_terminal():
    assert safe("\x1b[2Jgone\x07 \x9b1m") == "�[2Jgone� �1m"
    assert safe("ok · 漢") == "ok · 漢"
    assert safe("a\nb\x85c\r\n") == "a\nb\nc"
    assert safe("") == ""
    assert safe("a\tb") == "a   b"
