"""What a lesson adds to a scene in its fence: controls, presets, predictions, a map."""
