import signal
import threading

import pytest

from onika.desk.run.interruption import Interruption


def control_c():
    signal.raise_signal(signal.SIGINT)


def test_the_first_one_is_only_noted_and_told_once():  # R-E07
    with Interruption() as interruption:
        assert not interruption.is_new()
        control_c()
        assert interruption.is_new()
        assert not interruption.is_new()


def test_the_second_one_ends_everything():  # R-E07
    with Interruption() as interruption, pytest.raises(KeyboardInterrupt):
        control_c()
        interruption.is_new()
        control_c()


def test_whoever_is_asked_is_released_at_once_and_the_run_is_told_after():  # R-E07, R-E15
    with Interruption() as interruption:
        with interruption.at_once():
            control_c()
            pytest.fail("the question was not left")
        assert interruption.is_new()


def test_a_second_one_at_a_question_ends_everything():  # R-E07
    with Interruption() as interruption:
        control_c()
        with pytest.raises(KeyboardInterrupt), interruption.at_once():
            control_c()


def test_afterwards_everything_is_as_it_was():
    former = signal.getsignal(signal.SIGINT)
    with Interruption():
        assert signal.getsignal(signal.SIGINT) is not former
    assert signal.getsignal(signal.SIGINT) is former


def test_in_a_thread_of_its_own_nothing_is_noted():
    former, interrupts = signal.getsignal(signal.SIGINT), []

    def run():
        with Interruption() as interruption:
            interrupts.append(interruption.is_new())

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert interrupts == [False]
    assert signal.getsignal(signal.SIGINT) is former
