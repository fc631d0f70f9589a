"""A run from the environment's side: begun, followed, steered, recorded and told."""
