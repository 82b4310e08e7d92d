"""What the tests of this room start from: scenes, chosen and random, and their runs."""
