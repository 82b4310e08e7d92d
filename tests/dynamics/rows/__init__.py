"""Many carts that touch at once, and the hard cases."""
