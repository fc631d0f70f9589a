"""The run of an application beside the robot."""
