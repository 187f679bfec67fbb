#!/usr/bin/python3
"""What a desktop with a dense screen tells its programs: set_text_dpi.py DISPLAY DPI.

The interpreter by its path: python3-xlib is the distribution's.
"""

import sys

from Xlib import Xatom, display

screen = display.Display(sys.argv[1])
resource = f"Xft.dpi:\t{int(sys.argv[2])}\n".encode("ascii")
screen.screen().root.change_property(Xatom.RESOURCE_MANAGER, Xatom.STRING, 8, resource)
screen.sync()
