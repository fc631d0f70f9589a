from onika.ring.begin_words import SIZE, BeginWords


def test_what_the_program_writes_the_unit_reads():  # decision 56
    memory = memoryview(bytearray(SIZE + 5))
    program, unit = BeginWords(memory), BeginWords(memory)
    assert not (unit.is_permitted(1) or unit.is_confirmed(1))
    program.permit(1)
    assert (unit.is_permitted(1), unit.is_confirmed(1)) == (True, False)
    program.confirm(1)
    assert unit.is_confirmed(1)


def test_appointments_do_not_meddle_with_each_other():
    words = BeginWords()
    for number in range(1, 9):
        words.permit(number)
    words.revoke(3)
    assert [number for number in range(1, 9) if words.is_permitted(number)] == [1, 2, 4, 5, 6, 7, 8]
    assert not any(words.is_confirmed(number) for number in range(1, 9))


def test_a_place_is_of_the_last_number_that_has_it():
    words = BeginWords()
    words.permit(1)
    words.permit(9)
    words.revoke(1)
    assert (words.is_permitted(1), words.is_permitted(9)) == (False, True)


def test_what_is_revoked_is_not_permitted_and_neighbours_keep_what_they_were_told():
    words = BeginWords()
    words.permit(1)
    words.revoke(1)
    assert not words.is_permitted(1)
    words.confirm(1)
    words.permit(2)
    assert (words.is_confirmed(1), words.is_permitted(2), SIZE) == (True, True, 128)
