"""All SQL of the tables that the application writes itself; the catalogue's stands in ``app.catalog``."""
