"""The expert learns a goal."""

from onika.module import GuestAction, Input


class ExpertLearns(GuestAction):
    """Tells an expert system what shall be so in the end.

    Kind     trigger, synchronous, 1..100 Hz
    Local    GUEST     string  -  name of the guest
             PARTNER   line    -  where the guest listens: unix:PATH or tcp:HOST:PORT
             STARTS    line    -  what starts the guest, if the task is to do that
             PATIENCE  double  s  how long the action may take
    Input    goal      line    -  clauses such as `square on triangle`
    Finish   flow 0, loop FALSE, when the expert has done so
    Errors   no answer    ERROR: the expert is gone, refuses, or takes longer than PATIENCE
    Source   Gertz and Khosla, section III
    """

    action = "learn"

    goal = Input("line", "-", "clauses such as `square on triangle`")
