from onika.host.guards.code_watch import GAVE_UP
from onika.host.guards.watchman import ROUNDS, Watchman


class CodeLook:
    def __init__(self):
        self.looks = 0

    def look(self):
        self.looks += 1


class Calls:
    task, calls = "", 0

    def watch(self, task):
        self.task, self.calls = task, self.calls + 1


class Program:
    """A program that runs calls of tasks, and a watchman over it."""

    def __init__(self):
        self.code, self.calls, self.said, self.codes = CodeLook(), Calls(), [], []
        self.watchman = Watchman(self.code, self.calls, self.said.append, self.codes.append)

    def looks(self, count):
        for _ in range(count):
            self.watchman.look()


def test_a_call_that_nobody_can_interrupt_ends_the_program_and_is_named():  # law 15
    program = Program()
    program.calls.watch("flow0/sick")
    program.looks(ROUNDS)
    assert program.codes == []
    program.looks(1)
    assert program.codes == [GAVE_UP]
    expected = "a call of task flow0/sick has not returned for 20 s, and could not be interrupted"
    assert [str(reason) for reason in program.said] == [expected]


def test_calls_that_return_are_none_that_hangs():  # law 15
    program = Program()
    for _ in range(3):
        program.calls.watch("flow0/brisk")
        program.looks(ROUNDS)
    assert program.codes == []


def test_a_program_that_waits_for_somebody_may_wait_for_ever():  # law 15
    program = Program()
    program.calls.watch("flow0/brisk")
    program.calls.watch("")
    program.looks(3 * ROUNDS)
    assert program.codes == []


def test_each_look_is_one_at_our_own_code():  # law 14
    program = Program()
    program.looks(5)
    assert program.code.looks == 5
