"""Steps by a power series in time: its coefficients, what it is worth, where it turns or ends."""
