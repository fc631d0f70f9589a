"""`onika fabric`: other sites are found, and this one is announced (requirement F06)."""

from onika.cli.fabric.command import carry_out as carry_out, describe as describe, purpose as purpose
