"""What the tests of this room start from: words that can be told, and a site in two languages."""
