"""What tests of the environment act on: environments with little in them, and runtimes that are none."""
