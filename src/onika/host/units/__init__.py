"""The processes and clocks in which tasks and worlds run."""
