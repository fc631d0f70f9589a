"""The agent of a site: it launches what its owner has listed, and says what runs on the machine of the robots."""
