"""YAML as an author writes it: every value with its place, every slip with a readable mistake."""
