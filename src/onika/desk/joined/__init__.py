"""One application on several runtimes, which meet at tags."""
