"""The law of the runtime once more, as a plain interpreter: what the executive does has to be what it says."""
