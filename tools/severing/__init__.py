"""A campaign that cuts lines and kills runtimes while flows of three sites wait for each other (tools/sever.py)."""
