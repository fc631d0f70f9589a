"""Sites that announce themselves, honestly or not."""
