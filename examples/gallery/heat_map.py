"""
The whole beam over time
========================

w(x, t) under control and without, on the same scale.
"""

import matplotlib.pyplot as plt

plt.plot([1, 2, 3])
