"""The expert chooses."""

from onika.module import GuestAction


class ExpertChooses(GuestAction):
    """Has an expert system choose which flow is taken.

    Kind     trigger, synchronous, 1..100 Hz
    Local    GUEST     string  -  name of the guest
             PARTNER   line    -  where the guest listens: unix:PATH or tcp:HOST:PORT
             STARTS    line    -  what starts the guest, if the task is to do that
             PATIENCE  double  s  how long the action may take
    Finish   the flow that the expert chooses, loop FALSE
    Errors   no answer    ERROR: the expert is gone, refuses, or takes longer than PATIENCE
    Source   Gertz and Khosla, section III
    """

    action = "which"
