"""`onika library`: base directories are published, and libraries of others used and changed (requirement F03)."""

from onika.cli.library.command import carry_out as carry_out, describe as describe, purpose as purpose
