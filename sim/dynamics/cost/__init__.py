"""What accuracy costs: every method on one scene, its error against its time."""
