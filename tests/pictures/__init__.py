"""Pictures of the docs that are taken from the real pages: `make pictures`."""
