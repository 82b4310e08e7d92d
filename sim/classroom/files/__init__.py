"""What a teacher has: answer files, zips, keys, marks and typed codes, read with bounds."""
