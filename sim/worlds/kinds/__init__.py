"""Each world in a module of its own, named like it: KIND describes it, `act` are its forces."""
