# SPDX-License-Identifier: MIT
"""The version of the client: that of the program it comes with."""
__version__ = "0.1.0"
