"""The times for which robots of a site are booked: one book, whose writer is the site itself (requirement F09)."""
