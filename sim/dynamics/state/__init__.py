"""What moves: bodies in a row, the gaps between them, contacts in progress, loads, time."""
