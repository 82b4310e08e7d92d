"""Rows of spheres: power series in the time of the contact that is nearest to its touch or end."""
