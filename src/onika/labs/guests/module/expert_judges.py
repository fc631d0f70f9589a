"""The expert judges."""

from onika.module import GuestAction, InVar


class ExpertJudges(GuestAction):
    """Has an expert system judge whether its goal is reached; it is told whether the lamp is lit.

    Kind     trigger, synchronous, 1..100 Hz
    Ports    INVAR  LAMP  int  -  1 while the lamp is lit, else 0
    Local    GUEST     string  -  name of the guest
             PARTNER   line    -  where the guest listens: unix:PATH or tcp:HOST:PORT
             STARTS    line    -  what starts the guest, if the task is to do that
             PATIENCE  double  s  how long the action may take
    Finish   flow 0, loop TRUE while the goal is not reached
    Errors   no answer    ERROR: the expert is gone, refuses, or takes longer than PATIENCE
    Source   Gertz and Khosla, section III
    """

    action = "judge"

    LAMP = InVar("int", "-", "1 while the lamp is lit, else 0")
