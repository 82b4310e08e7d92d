"""Every Python that the project may meet: the oldest that it promises, and those between."""
