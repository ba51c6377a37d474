"""Flow: each entry takes (records, folder of figures) and returns its section, or None where its test was not run."""

entries = []
