"""Messages as somebody may send them: honest, garbled, and any at all."""
