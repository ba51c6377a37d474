"""Mutants of the laws, all in one build: which there are, how they get into the code, which test notices them."""
