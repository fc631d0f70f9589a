"""Bytes from a session become a request that means something, or a reason why not (requirement F01).

The types are the structs' business; here stands what types cannot say: how deep, how long, which names and numbers.
Whatever passes can be carried out or refused; nothing that it says is believed later without a look.
"""

from math import isfinite

import msgspec

from onika.host.loading.plan_form import wrong_name
from onika.model import pad
from onika.record import topics
from onika.wire import holding, live, request, steer
from onika.wire.samples import Sample
from onika.words.reason import NOTHING, Reason

_LONGEST_NAME = 4096
_MOST_WATCHED = 1000
_LONGEST_WAIT_S = 3600.0
_LONGEST_WAIT_NS = 10**18
_ON_LOSS = ("stop", "finish", "run")
_ON_ERROR = ("abort", "wait")


def decode(body: bytes) -> request.Request:
    """The request; raises ValueError with a reason for anything that is none."""
    try:
        message: request.Request = request.decode_request(body)
    except RecursionError:
        raise ValueError(Reason.of("host.request_deep")) from None
    except (msgspec.MsgspecError, ValueError) as error:
        raise ValueError(Reason.of("host.no_request", why=Reason.plain(str(error)))) from None
    reason = _wrong(message)
    if reason:
        raise ValueError(Reason.of("host.no_request", why=reason))
    return message


def _wrong(message: request.Request) -> Reason:
    """What is wrong with a request that has the right types."""
    match message:
        case request.Begin():
            return _wrong_begin(message)
        case live.Take() | live.Change():
            return wrong_name(message.subsystem, "subsystem")
        case live.Record():
            return _wrong_record(message)
        case live.Attend():
            return _wrong_attend(message)
        case Sample() if any(len(name) > _LONGEST_NAME for name in message.variables):
            return Reason.of("host.text_form", what="variables", most=_LONGEST_NAME)
        case holding.Listen():
            return _wrong_listen(message)
        case live.Advance():
            return _within("seconds", message.seconds)
        case live.Touch() if not isfinite(message.value):
            return Reason.of("host.number_infinite", name="value")
        case live.Push():
            return _wrong_push(message)
        case steer.Onward() if message.until_s is not None and not abs(message.until_s) <= _LONGEST_WAIT_NS * 1e-9:
            return Reason.of("host.number_infinite", name="until_s")
    return NOTHING


def _wrong_push(push: live.Push) -> Reason:
    if not all(isfinite(axis) for axis in (*push.axes, push.scale)):
        return Reason.of("host.number_infinite", name="axes")
    if push.frame not in pad.FRAMES:
        return Reason.of("host.word_unknown", name="frame", words=pad.FRAMES)
    if len(push.source) > _LONGEST_NAME:
        return Reason.of("host.text_form", what="source", most=_LONGEST_NAME)
    return NOTHING


def _wrong_begin(begin: request.Begin) -> Reason:
    if begin.on_loss not in _ON_LOSS:
        return Reason.of("host.word_unknown", name="on_loss", words=_ON_LOSS)
    if begin.on_error not in _ON_ERROR:
        return Reason.of("host.word_unknown", name="on_error", words=_ON_ERROR)
    if not -1 <= begin.repeat_until_ns <= _LONGEST_WAIT_NS:
        return Reason.of("host.number_infinite", name="repeat_until_ns")
    if len(begin.record) > _LONGEST_NAME or "\0" in begin.record:
        return Reason.of("host.text_form", what="record", most=_LONGEST_NAME)
    reasons = (_wrong_recorded(recorded) for recorded in begin.repeat)
    return _within("settle_s", begin.settle_s) or next((reason for reason in reasons if reason), NOTHING)


def _wrong_record(record: live.Record) -> Reason:
    if len(record.path) > _LONGEST_NAME or "\0" in record.path:
        return Reason.of("host.text_form", what="path", most=_LONGEST_NAME)
    return wrong_name(record.subsystem, "subsystem")


def _wrong_listen(listen: holding.Listen) -> Reason:
    """Places, files and names go to the operating system, which takes no such texts."""
    fields = ("place", "certificate", "key", "users")
    texts = [(field, getattr(listen, field)) for field in fields] + [("names", name) for name in listen.names]
    for field, text in texts:
        if len(text) > _LONGEST_NAME or "\0" in text:
            return Reason.of("host.text_form", what=field, most=_LONGEST_NAME)
    return NOTHING


def _wrong_recorded(recorded: request.Recorded) -> Reason:
    """A request to be repeated has to be one of those that recordings keep: no run begins or ends a runtime again."""
    if not 0 <= recorded.at_ns <= _LONGEST_WAIT_NS:
        return Reason.of("host.number_infinite", name="at_ns")
    try:
        message = decode(recorded.body)
    except ValueError:
        return Reason.of("host.not_repeated", request="?")
    if not isinstance(message, topics.STEERING):
        return Reason.of("host.not_repeated", request=type(message).__name__)
    return NOTHING


def _wrong_attend(attend: live.Attend) -> Reason:
    for name, texts in (("subsystems", attend.subsystems), ("readings", attend.readings), ("worlds", attend.worlds)):
        if len(texts) > _MOST_WATCHED or any(len(text) > _LONGEST_NAME for text in texts):
            return Reason.of("host.too_many_watched", name=name, most=_MOST_WATCHED)
    return NOTHING


def _within(name: str, seconds: float) -> Reason:
    if 0.0 <= seconds <= _LONGEST_WAIT_S:
        return NOTHING
    return Reason.of("host.seconds_range", name=name, most=_LONGEST_WAIT_S, seconds=seconds)
