"""Rows of bodies under linear laws: what moves them next, and what they are just now."""
