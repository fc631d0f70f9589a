"""The environment program: reads sites, prepares runs, follows them on a connected runtime."""
