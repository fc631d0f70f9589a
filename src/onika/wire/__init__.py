"""Messages as bytes: what environment and runtime say to each other. No sockets."""
