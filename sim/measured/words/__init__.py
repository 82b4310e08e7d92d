"""What is said of readings: of a fit, of what brakes, of two force sensors, of two phones."""
