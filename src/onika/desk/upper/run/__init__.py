"""Runs of open applications: judged, begun, steered, told and shown."""
