"""Boundary control and iterative learning control of vibrating structures.

The public names are listed in `__init__.pyi`; each is imported when it is first asked for.
"""

from lazy_loader import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
