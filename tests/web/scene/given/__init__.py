"""What the tests of this room start from: requests of a page, counted."""
