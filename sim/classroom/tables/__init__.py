"""Anybody's marks, read from a table: one module for each kind of export."""
