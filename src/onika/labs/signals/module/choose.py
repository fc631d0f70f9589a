"""A choice that the program makes itself."""

from onika.module import Input, Module, finish


class FlowChoice(Module):
    """Takes the flow that its target names: a switch in a program that is set by exchanging an icon.

    Kind     trigger, periodic, 1..1000 Hz
    Input    index  int  -  0..1000
    Finish   flow index, loop FALSE, at its first cycle
    Source   dissertation §4.4.7.2
    """

    trigger = True

    index = Input("int", "-", "which flow, counted from 0", low=0, high=1000)

    def on(self, inputs):
        self._flow = int(inputs.index)

    def cycle(self):
        return finish(flow=self._flow)
