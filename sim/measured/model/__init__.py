"""Two carts that meet: the model that readings are compared with, its fit, what is believed."""
