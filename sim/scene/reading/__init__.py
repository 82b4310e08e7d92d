"""Parts of a scene that take more than a number to read: contacts, effects, laws, tolerances."""
