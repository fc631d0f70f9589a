from onika.host.run.input_requests import InputRequests
from onika.runtime import news
from onika.runtime.user_input import AskedItem
from onika.wire.request import Begin

ITEM = AskedItem("goal", "double", 1, "m", "where to", None, None, None)


def question_with(*items, task="servo", reason=""):
    return news.Asked("flow0", task, reason, items or (ITEM,), 5)


class Desk:
    def __init__(self, **begin):
        self.told, self.answers, self.causes = [], [], []
        self.requests = InputRequests(
            Begin(**begin), lambda *answer: self.answers.append(answer), self.told.append, self.causes.append
        )

    def ask(self, *items, **what):
        self.requests.ask(question_with(*items, **what))
        return self


def test_a_given_answer_is_used_once_and_then_somebody_is_asked():  # law 25
    desk = Desk(answers=(("servo", "goal", "3"),), may_ask=True).ask().ask()
    assert desk.answers == [("flow0", "servo", "3")]
    assert [question.task for question in desk.told] == ["servo"]


def test_a_question_without_anybody_ends_the_run_and_names_what_was_asked():  # law 25
    desk = Desk().ask(reason="9 is too far")
    assert list(map(str, desk.causes)) == [
        "task servo asks for servo.goal (9 is too far) and nobody is there to answer"
    ]


def test_an_answer_for_something_else_ends_the_run():  # law 25
    desk = Desk(answers=(("servo", "speed", "3"),)).ask()
    assert list(map(str, desk.causes)) == ["task servo asks for goal, and an answer is given for speed"]
    assert desk.answers == []
