"""What a control module is: its class, its declaration, and how an instance is bound to its task."""
