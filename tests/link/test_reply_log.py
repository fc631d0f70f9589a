from onika.link.reply_log import ReplyLog, StoredReply


def test_a_request_is_new_once():  # R-F07
    account = ReplyLog().begin("me")
    assert account.is_new(1)
    account.under_way.add(1)
    assert not account.is_new(1)
    assert account.answer(1, StoredReply(b"yes"))
    assert not account.is_new(1)
    assert account.answers == {1: StoredReply(b"yes")}


def test_answers_that_the_client_has_are_let_go_and_their_numbers_stay_old():
    account = ReplyLog().begin("me")
    for number in (1, 2, 3):
        account.answer(number, StoredReply(b"%d" % number))
    account.settle(3)
    assert list(account.answers) == [3]
    assert not account.is_new(2)
    account.settle(1)
    assert not account.is_new(2)


def test_an_answer_that_nobody_wants_any_more_is_not_kept():
    account = ReplyLog().begin("me")
    account.under_way.add(1)
    account.settle(2)
    assert not account.answer(1, StoredReply(b"late"))
    assert account.answers == {}


def test_the_client_that_has_been_away_longest_is_forgotten_first():
    book = ReplyLog(keep=2)
    first = book.begin("first")
    book.begin("second")
    book.renew("first")
    book.begin("third")
    assert book.find("first") is first
    assert book.find("second") is None


def test_a_client_that_begins_anew_or_leaves_has_no_past():
    book = ReplyLog()
    old = book.begin("me")
    assert book.begin("me") is not old
    book.close("me")
    book.close("me")
    assert book.find("me") is None
