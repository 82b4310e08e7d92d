"""The command `carts class`."""
