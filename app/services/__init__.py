"""Use cases: what a reader or a program can ask for. Pages, REST and command line call the same ones."""
