"""Ways to a runtime that is only started when somebody comes."""
