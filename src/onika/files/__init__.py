"""The formats of appendix A: text to model and back, one file a format."""
