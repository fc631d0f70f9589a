"""Open applications: their flows, how they are edited, filed and shown."""
