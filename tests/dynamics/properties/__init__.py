"""Laws that hold in any scene, tried on random ones."""
