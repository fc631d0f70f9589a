"""The table of all console commands, in the groups in which `help` shows them."""

from onika.desk.console import (
    control_lines,
    inspection,
    readings_log,
    run_lines,
    steering_lines,
    task_lines,
    time_lines,
    transfer_lines,
    tuning_lines,
    world_lines,
)
from onika.desk.console.command import Command
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.run.steering import VERBS

Words = tuple[str, ...]


def _echo(session: ConsoleSession, words: Words) -> Faults:
    session.say(words[0] if words else "")
    return ()


TASKS = (
    Command(
        "spawn",
        "spawn TASK… [on RTPU] [as NAME] [at HZ]  |  spawn all of CONFIGURATION",
        "bring tasks to life, OFF\n"
        "Tasks are found on the search path. A task waits for its constants' suppliers, so the order\n"
        "does not matter. `as` gives one task another name, `at` another rate.",
        task_lines.spawn,
        ("library", "spawn words"),
        1,
    ),
    Command(
        "on",
        "on TASK [ARGUMENTS | @TARGET]  |  on all",
        "turn a task ON, with its argument line\n"
        "What it lacks it asks for. `@home` means the values of the target home.",
        task_lines.on,
        ("task",),
        1,
        raw=1,
    ),
    Command(
        "off",
        "off [TASK… | all]",
        "turn tasks OFF, all of the subsystem where none is named",
        task_lines.off,
        ("task",),
    ),
    Command("kill", "kill TASK…  |  kill all", "end tasks", task_lines.kill, ("task",), 1),
    Command(
        "clear",
        "clear [TASK | FLOW]",
        "bring a task, or all, out of ERROR; of a flow: clear and continue\n"
        "A flow that has stopped repeats its action with the same target.",
        steering_lines.clear,
        ("task",),
        0,
        1,
    ),
    Command(
        "config",
        "config NAME [ARGUMENTS | @TARGET]",
        "have exactly the tasks of a configuration, ON\n"
        "Tasks that are there already keep cycling untouched, new ones are spawned first, the others killed.\n"
        "The arguments go to the task that takes a target. All of it is done, or nothing.",
        task_lines.configure,
        ("configuration", ""),
        1,
        raw=1,
    ),
    Command(
        "answer",
        "answer TASK [ARGUMENTS | @TARGET]",
        "answer a task that asks\n"
        "Without arguments: the defaults. At a prompt the answer alone does, as long as it does not begin\n"
        "with the name of a command.",
        tuning_lines.answer,
        ("asking", ""),
        1,
        raw=1,
    ),
)

CHANGES = (
    Command("rate", "rate TASK HZ", "another rate, while it runs", tuning_lines.rate, ("task", ""), 2, 2),
    Command("get", "get TASK NAME", "ask its module for something by name", tuning_lines.get, ("task", ""), 2, 2),
    Command(
        "set",
        "set TASK NAME VALUE",
        "tell its module a new value of something",
        tuning_lines.put,
        ("task", ""),
        3,
        raw=2,
    ),
    Command(
        "reinit",
        "reinit TASK [KEY WORDS…]",
        "initialise it anew, with another LOCAL line where one is given\n"
        "Who needs its constants is initialised anew after it.",
        tuning_lines.reinit,
        ("task", ""),
        1,
    ),
    Command(
        "swap",
        "swap TASK [FILE]",
        "exchange its code for what its file holds now",
        tuning_lines.swap,
        ("task", "file"),
        1,
        2,
    ),
)

LOOKS = (
    Command(
        "status",
        "status [TASK…]",
        "figures of tasks, loads of units; counters begin anew\n"
        "The columns are those of STATINFO in your preferences; with a task, all of them. Loads that are or will be\n"
        "too much are told.",
        inspection.status,
        ("task",),
    ),
    Command("tasks", "tasks [SUBSYSTEM]", "the living tasks", inspection.tasks, ("subsystem",), 0, 1),
    Command(
        "library",
        "library [PATTERN]",
        "tasks, configurations and applications that there are to use",
        inspection.library,
        ("library",),
        0,
        1,
    ),
    Command("rtpus", "rtpus", "the processing units and their loads", inspection.rtpus, most=0),
    Command("subsystems", "subsystems", "the subsystems and who holds them", inspection.subsystems, most=0),
    Command(
        "subsystem",
        "subsystem [NAME]",
        "choose the subsystem that the other lines mean\n`SUBSYSTEM/NAME` means another one in any line.",
        inspection.choose,
        ("subsystem",),
        0,
        1,
    ),
    Command(
        "vars", "vars [PATTERN]", "variables with their types and values", inspection.variables, ("variable",), 0, 1
    ),
    Command("read", "read NAME…", "the values of variables now", inspection.read, ("variable",), 1),
    Command(
        "log",
        "log FILE [SUBSYSTEM…]",
        "write all readings to a file\n"
        "One line for each variable: time, subsystem, name, type, values. The file is written whole or not at all.",
        readings_log.log,
        ("file", "subsystem"),
        1,
    ),
    Command(
        "jumps",
        "jumps [SUBSYSTEM]",
        "how far inputs of hardware stepped at switches\n"
        "What one cycle may change, the robot's module says. A larger step is blended, or refused: the drive holds.",
        transfer_lines.jumps,
        ("subsystem",),
        0,
        1,
    ),
    Command("check", "check [SUBSYSTEM…]", "check the memory of variables", inspection.check, ("subsystem",)),
)


def _verb(name: str) -> Command:
    """A word of steering, as scripts of runs have it."""
    return Command(name, VERBS[name].usage, VERBS[name].text, steering_lines.verb(name), ("flow", ""))


FLOWS = (
    Command("runs", "runs", "the applications that run, and where their flows are", steering_lines.runs, most=0),
    Command("who", "who", "where every flow is, and who waits for whom", steering_lines.who, most=0),
    *(_verb(name) for name in ("pause", "continue", "step", "next", "skip", "pass", "leave", "break", "unbreak")),
)

WHOLE = (
    Command(
        "run",
        "run APPLICATION [[FLOW:]TASK=TASK …]",
        "run an application\nIn a script the next line waits for its end, or for a question, which it may answer."
        "\nThen `wait run` waits for the end."
        "\n`puma=scara` redirects it to another task in all flows, `0:puma=scara` in one; its file stays as it is.",
        run_lines.run,
        ("application", ""),
        1,
    ),
    Command(
        "begin",
        "begin APPLICATION [[FLOW:]TASK=TASK …]",
        "run an application, and go on with the next line at once",
        run_lines.begin,
        ("application", ""),
        1,
    ),
    Command("abort", "abort [CAUSE]", "end the run: tasks off, drives in hold", run_lines.abort),
    Command("home", "home", "run the application go_home", run_lines.home, most=0),
    Command(
        "calibrate",
        "calibrate [ROBOT]",
        "run the application calibrate, or calibrate_ROBOT, of the laboratory\n"
        "The shipped arms measure absolute angles and need none; there it says so.",
        run_lines.calibrate,
        most=1,
    ),
    Command(
        "stop", "stop [CAUSE]", "every drive holds, at once, until `reset`; Ctrl-C does the same", control_lines.stop
    ),
    Command("reset", "reset", "allow motion again", control_lines.reset, most=0),
    Command(
        "touch",
        "touch WORLD PART VALUE  |  touch WORLD",
        "touch a part of a world, such as a panic button\n"
        "Without a part it says what there is. `touch boxes panic_left 1` presses the panic button of the left\n"
        "arm: its drive holds, its task is in ERROR. With 0 it is let go; then the task can be cleared.",
        world_lines.touch,
        ("world", ""),
        1,
        3,
    ),
    Command(
        "take",
        "take [SUBSYSTEM]",
        "become the one who may change a subsystem",
        control_lines.take,
        ("subsystem",),
        0,
        1,
    ),
    Command("release", "release [SUBSYSTEM]", "let another change it", control_lines.release, ("subsystem",), 0, 1),
    Command(
        "hand",
        "hand [SESSION [SUBSYSTEM]]",
        "offer a subsystem to another session\n"
        "It is told, and says `take` or `decline`; what is ON stays ON. Without a name the offer is withdrawn;\n"
        "after a minute it is over. `sessions` says who is there.",
        control_lines.hand,
        ("", "subsystem"),
        0,
        2,
    ),
    Command("decline", "decline [SUBSYSTEM]", "say no to what is offered", control_lines.decline, ("subsystem",), 0, 1),
    Command("sessions", "sessions", "who is there, and what each of them holds", control_lines.sessions, most=0),
    Command("open", "open [HOST:PORT]", "say where others reach this runtime", control_lines.open_channel, most=1),
    Command("listen", "listen [HOST:PORT]", "the same as open", control_lines.open_channel, most=1),
    Command("network", "network", "the same as open", control_lines.open_channel, most=0),
    Command("advance", "advance SECONDS", "in virtual time: let time pass", time_lines.advance, (), 1, 1),
    Command(
        "wait",
        "wait SECONDS  |  wait CONDITION [within SECONDS]",
        "wait, in the runtime's time\n"
        "Conditions: `run` (its end), `TASK STATE` as in `jtraj off`, `FLOW STATE` as in `flow0 paused`,\n"
        "a comparison as in `Q_MEZ[0] > 0.5`.\n"
        "60 s where nothing is said; then the line fails.",
        time_lines.wait,
        ("task", "state"),
        1,
        raw=0,
    ),
    Command("echo", "echo [TEXT]", "say a line", _echo, raw=0),
)
