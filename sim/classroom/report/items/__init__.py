"""What a class answered, item by item: rows of plain values, and their sentences."""
