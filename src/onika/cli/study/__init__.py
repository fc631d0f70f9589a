"""`onika study`: studies with people, from the order of subjects to the report (requirements H02, H03, H05, H09)."""

from onika.cli.study.command import carry_out as carry_out, describe as describe, purpose as purpose
