"""The upper level: what its three packages share, the words and types of icons, their values and pictures."""
