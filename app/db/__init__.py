"""Database layer: tables, sessions, migrations. Knows nothing of the web and of what the numbers are used for."""
