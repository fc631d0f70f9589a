"""What is done to signals, whatever they mean: filters, limits, presses of a button."""
