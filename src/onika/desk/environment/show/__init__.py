"""The tree that every page is shown, made of the model."""
