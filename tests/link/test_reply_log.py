from onika.link.reply_log import ReplyLog, StoredReply


def test_a_request_is_new_once():  # R-F07
    client_replies = ReplyLog().begin("me")
    assert client_replies.is_new(1)
    client_replies.under_way.add(1)
    assert not client_replies.is_new(1)
    assert client_replies.answer(1, StoredReply(b"yes"))
    assert not client_replies.is_new(1)
    assert client_replies.answers == {1: StoredReply(b"yes")}


def test_answers_that_the_client_has_are_let_go_and_their_numbers_stay_old():
    client_replies = ReplyLog().begin("me")
    for number in (1, 2, 3):
        client_replies.answer(number, StoredReply(b"%d" % number))
    client_replies.settle(3)
    assert list(client_replies.answers) == [3]
    assert not client_replies.is_new(2)
    client_replies.settle(1)
    assert not client_replies.is_new(2)


def test_an_answer_that_nobody_wants_any_more_is_not_kept():
    client_replies = ReplyLog().begin("me")
    client_replies.under_way.add(1)
    client_replies.settle(2)
    assert not client_replies.answer(1, StoredReply(b"late"))
    assert client_replies.answers == {}


def test_the_client_that_has_been_away_longest_is_forgotten_first():
    log = ReplyLog(keep=2)
    first = log.begin("first")
    log.begin("second")
    log.renew("first")
    log.begin("third")
    assert log.find("first") is first
    assert log.find("second") is None


def test_a_client_that_begins_anew_or_leaves_has_no_past():
    log = ReplyLog()
    old = log.begin("me")
    assert log.begin("me") is not old
    log.close("me")
    log.close("me")
    assert log.find("me") is None
