"""An application as text in the words of AL (dissertation §4.4), written and read back."""
