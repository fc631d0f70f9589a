"""How late a task of 500 Hz begins its cycles, under SCHED_FIFO where that is granted."""
