"""What comes of an act: a new model, or a refusal with its remedies."""
