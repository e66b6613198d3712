"""`python -m dampen.cli`."""

from dampen.cli import main

main()
