"""What a run leaves behind: events, accounts of momentum and energy, curves."""
