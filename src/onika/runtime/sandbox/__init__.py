"""Modules of others in a process that can do nothing but compute: both ends of what is said, without any process."""
