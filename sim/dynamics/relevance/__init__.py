"""What does a scene call for? Each effect is added or left out, and the scene really run."""
