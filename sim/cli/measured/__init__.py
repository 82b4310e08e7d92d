"""The command `carts fit`."""
