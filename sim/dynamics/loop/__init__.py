"""The run: the next event is found, carried out, and what it changes is predicted anew."""
