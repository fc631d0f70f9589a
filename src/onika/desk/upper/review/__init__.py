"""Recorded runs that are looked at: opened, scrubbed, drawn, compared (requirement X05)."""
