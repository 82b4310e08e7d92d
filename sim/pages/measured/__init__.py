"""The block `measured`: readings of real carts beside the model."""
