# SPDX-License-Identifier: MIT
# Generated from CMakeLists.txt by proto/spec/generate.py; do not edit.
"""The version of the client: that of the program it comes with."""
__version__ = "0.1.0"
