"""What the tests of this room start from: made-up classes, tables and reports."""
