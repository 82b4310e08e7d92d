"""Rows in which every force is linear, as sums of modes: their cost is that of what swings."""
