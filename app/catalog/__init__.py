"""Catalogue: published data as CSV files with their sources -> checks -> tables -> products in SI for the engine."""
