"""Answers of a country: as a table, and the report from it, held equal to that of the files."""
