"""Libraries of others: signed, named file by file in a lock, fetched by need, kept by what they hold."""
