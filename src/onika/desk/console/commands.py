"""The table of all console commands, in the groups in which `help` shows them."""

from onika.desk.console import (
    again_lines,
    booking_lines,
    channel_lines,
    control_lines,
    foresight_lines,
    inspection,
    readings_log,
    recording_lines,
    run_lines,
    scope_lines,
    steering_lines,
    target_lines,
    task_lines,
    time_lines,
    transfer_lines,
    tuning_lines,
    unit_lines,
    world_lines,
)
from onika.desk.console.command import Command
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.run.steering import VERBS
from onika.words.reason import Reason

Words = tuple[str, ...]


def _echo(session: ConsoleSession, words: Words) -> Faults:
    session.say(Reason.plain(words[0] if words else ""))
    return ()


TASKS = (
    Command(
        "spawn",
        "spawn TASK… [on RTPU] [as NAME] [at HZ]  |  spawn all of CONFIGURATION",
        Reason.of("console.does_spawn"),
        task_lines.spawn,
        ("library", "spawn_word"),
        1,
        more=Reason.of("console.more_spawn"),
    ),
    Command(
        "on",
        "on TASK [ARGUMENTS | @TARGET]  |  on all",
        Reason.of("console.does_on"),
        task_lines.on,
        ("task",),
        1,
        raw=1,
        more=Reason.of("console.more_on"),
    ),
    Command("off", "off [TASK… | all]", Reason.of("console.does_off"), task_lines.off, ("task",)),
    Command("kill", "kill TASK…  |  kill all", Reason.of("console.does_kill"), task_lines.kill, ("task",), 1),
    Command(
        "clear",
        "clear [TASK | FLOW]",
        Reason.of("console.does_clear"),
        steering_lines.clear,
        ("task",),
        0,
        1,
        more=Reason.of("console.more_clear"),
    ),
    Command(
        "config",
        "config NAME [ARGUMENTS | @TARGET]",
        Reason.of("console.does_config"),
        task_lines.configure,
        ("configuration", ""),
        1,
        raw=1,
        more=Reason.of("console.more_config"),
    ),
    Command(
        "switch",
        "switch NAME [ARGUMENTS | @TARGET]",
        Reason.of("console.does_switch"),
        task_lines.switch,
        ("configuration", ""),
        1,
        raw=1,
        more=Reason.of("console.more_switch"),
    ),
    Command(
        "answer",
        "answer TASK [ARGUMENTS | @TARGET]",
        Reason.of("console.does_answer"),
        tuning_lines.answer,
        ("asking", ""),
        1,
        raw=1,
        more=Reason.of("console.more_answer"),
    ),
)

CHANGES = (
    Command(
        "again",
        "again RTPU  |  again hold",
        Reason.of("console.does_again"),
        again_lines.again,
        ("again_word",),
        1,
        1,
        more=Reason.of("console.more_again"),
    ),
    Command("rate", "rate TASK HZ", Reason.of("console.does_rate"), tuning_lines.rate, ("task", ""), 2, 2),
    Command("get", "get TASK NAME", Reason.of("console.does_get"), tuning_lines.get, ("task", ""), 2, 2),
    Command("set", "set TASK NAME VALUE", Reason.of("console.does_set"), tuning_lines.put, ("task", ""), 3, raw=2),
    Command("write", "write VARIABLE VALUE…", Reason.of("console.does_write"), tuning_lines.write, ("variable",), 2),
    Command(
        "reinit",
        "reinit TASK [KEY WORDS…]",
        Reason.of("console.does_reinit"),
        tuning_lines.reinit,
        ("task", ""),
        1,
        more=Reason.of("console.more_reinit"),
    ),
    Command("swap", "swap TASK [FILE]", Reason.of("console.does_swap"), tuning_lines.swap, ("task", "file"), 1, 2),
)

LOOKS = (
    Command(
        "status",
        "status [TASK…]",
        Reason.of("console.does_status"),
        inspection.status,
        ("task",),
        more=Reason.of("console.more_status"),
    ),
    Command("tasks", "tasks [SUBSYSTEM]", Reason.of("console.does_tasks"), inspection.tasks, ("subsystem",), 0, 1),
    Command("library", "library [PATTERN]", Reason.of("console.does_library"), inspection.library, ("library",), 0, 1),
    Command(
        "rtpus",
        "rtpus [add NAME]",
        Reason.of("console.does_rtpus"),
        unit_lines.rtpus,
        ("rtpu_word", "lost_unit"),
        0,
        2,
        more=Reason.of("console.more_rtpus"),
    ),
    Command("subsystems", "subsystems", Reason.of("console.does_subsystems"), inspection.subsystems, most=0),
    Command(
        "subsystem",
        "subsystem [NAME]",
        Reason.of("console.does_subsystem"),
        inspection.choose,
        ("subsystem",),
        0,
        1,
        more=Reason.of("console.more_subsystem"),
    ),
    Command("vars", "vars [PATTERN]", Reason.of("console.does_vars"), inspection.variables, ("variable",), 0, 1),
    Command("read", "read NAME…", Reason.of("console.does_read"), inspection.read, ("variable",), 1),
    Command(
        "log",
        "log FILE [SUBSYSTEM…]",
        Reason.of("console.does_log"),
        readings_log.log,
        ("file", "subsystem"),
        1,
        more=Reason.of("console.more_log"),
    ),
    Command(
        "target",
        "target NAME VARIABLE [TYPE] [DATUM=VALUES…] [in DIRECTORY]",
        Reason.of("console.does_target"),
        target_lines.target,
        ("", "variable", ""),
        2,
        more=Reason.of("console.more_target"),
    ),
    Command(
        "scope",
        "scope FILE SECONDS NAME…",
        Reason.of("console.does_scope"),
        scope_lines.scope,
        ("file", "", "variable"),
        3,
        more=Reason.of("console.more_scope"),
    ),
    Command(
        "record",
        "record [SUBSYSTEM] FILE|off",
        Reason.of("console.does_record"),
        recording_lines.record,
        ("subsystem", "file"),
        1,
        2,
        more=Reason.of("console.more_record"),
    ),
    Command(
        "jumps",
        "jumps [SUBSYSTEM]",
        Reason.of("console.does_jumps"),
        transfer_lines.jumps,
        ("subsystem",),
        0,
        1,
        more=Reason.of("console.more_jumps"),
    ),
    Command(
        "what-if",
        "what-if [FAULT [WHOM]]",
        Reason.of("console.does_what_if"),
        foresight_lines.what_if,
        ("fault", "foreseen"),
        0,
        2,
        more=Reason.of("console.more_what_if"),
    ),
    Command("check", "check [SUBSYSTEM…]", Reason.of("console.does_check"), inspection.check, ("subsystem",)),
)


def _verb(name: str) -> Command:
    """A word of steering, as scripts of runs have it."""
    return Command(name, VERBS[name].usage, VERBS[name].purpose, steering_lines.verb(name), ("flow", ""))


FLOWS = (
    Command("runs", "runs", Reason.of("console.does_runs"), steering_lines.runs, most=0),
    Command("who", "who", Reason.of("console.does_who"), steering_lines.who, most=0),
    *(_verb(name) for name in ("pause", "continue", "step", "next", "skip", "pass", "leave", "break", "unbreak")),
)

WHOLE = (
    Command(
        "run",
        "run APPLICATION [[FLOW:]OLD=NEW …] [FLOW@N …]",
        Reason.of("console.does_run"),
        run_lines.run,
        ("application", ""),
        1,
        more=Reason.of("console.more_run"),
    ),
    Command(
        "begin",
        "begin APPLICATION [[FLOW:]OLD=NEW …] [FLOW@N …]",
        Reason.of("console.does_begin"),
        run_lines.begin,
        ("application", ""),
        1,
        more=Reason.of("console.more_begin"),
    ),
    Command("abort", "abort [CAUSE]", Reason.of("console.does_abort"), run_lines.abort),
    Command("home", "home", Reason.of("console.does_home"), run_lines.home, most=0),
    Command(
        "calibrate",
        "calibrate [ROBOT]",
        Reason.of("console.does_calibrate"),
        run_lines.calibrate,
        most=1,
        more=Reason.of("console.more_calibrate"),
    ),
    Command("stop", "stop [CAUSE]", Reason.of("console.does_stop"), control_lines.stop),
    Command("reset", "reset", Reason.of("console.does_reset"), control_lines.reset, most=0),
    Command(
        "touch",
        "touch WORLD PART VALUE  |  touch WORLD",
        Reason.of("console.does_touch"),
        world_lines.touch,
        ("world", ""),
        1,
        3,
        more=Reason.of("console.more_touch"),
    ),
    Command("take", "take [SUBSYSTEM]", Reason.of("console.does_take"), control_lines.take, ("subsystem",), 0, 1),
    Command(
        "release", "release [SUBSYSTEM]", Reason.of("console.does_release"), control_lines.release, ("subsystem",), 0, 1
    ),
    Command(
        "hand",
        "hand [SESSION [SUBSYSTEM]]",
        Reason.of("console.does_hand"),
        control_lines.hand,
        ("", "subsystem"),
        0,
        2,
        more=Reason.of("console.more_hand"),
    ),
    Command(
        "decline", "decline [SUBSYSTEM]", Reason.of("console.does_decline"), control_lines.decline, ("subsystem",), 0, 1
    ),
    Command("sessions", "sessions", Reason.of("console.does_sessions"), control_lines.sessions, most=0),
    Command("bookings", "bookings", Reason.of("console.does_bookings"), booking_lines.bookings, most=0),
    Command(
        "book",
        "book BEGIN for LENGTH [finish] [NOTE]",
        Reason.of("console.does_book"),
        booking_lines.book,
        least=3,
        more=Reason.of("console.more_book"),
    ),
    Command("extend", "extend NUMBER for LENGTH", Reason.of("console.does_extend"), booking_lines.extend, least=3),
    Command("cancel", "cancel NUMBER", Reason.of("console.does_cancel"), booking_lines.cancel, least=1, most=1),
    Command(
        "open",
        "open [HOST:PORT] [ROLE] [cert=FILE key=FILE users=FILE]",
        Reason.of("console.does_open"),
        channel_lines.open_channel,
        most=5,
        more=Reason.of("console.more_open"),
    ),
    Command("listen", "listen [HOST:PORT] …", Reason.of("console.does_listen"), channel_lines.open_channel, most=5),
    Command("network", "network", Reason.of("console.does_listen"), channel_lines.open_channel, most=0),
    Command("close", "close", Reason.of("console.does_close"), channel_lines.close_channel, most=0),
    Command("advance", "advance SECONDS", Reason.of("console.does_advance"), time_lines.advance, (), 1, 1),
    Command(
        "wait",
        "wait SECONDS  |  wait CONDITION [within SECONDS]",
        Reason.of("console.does_wait"),
        time_lines.wait,
        ("task", "state"),
        1,
        raw=0,
        more=Reason.of("console.more_wait"),
    ),
    Command("echo", "echo [TEXT]", Reason.of("console.does_echo"), _echo, raw=0),
)
