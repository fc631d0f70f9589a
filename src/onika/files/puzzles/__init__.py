"""What is set as a task for learners."""
