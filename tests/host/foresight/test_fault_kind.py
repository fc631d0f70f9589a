from onika.host.foresight.questions import FAULTS


def test_every_fault_has_a_word_of_its_own_and_a_question():  # R-X24
    names = [fault.name for fault in FAULTS]
    assert len(set(names)) == len(names)
    questions = {fault.question("somebody").key for fault in FAULTS}
    assert len(questions) == len(FAULTS)
