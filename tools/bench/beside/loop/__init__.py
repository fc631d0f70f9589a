"""The loop of four blocks: path, differentiator, controller, joint; vectors of six, a step of 1 ms."""
