#!/usr/bin/python3
"""Another program, from which a file is dragged onto a window: the source's side of XDND, version 5
(https://www.freedesktop.org/wiki/Specifications/XDND/).

    drop_source.py DISPLAY WINDOW X Y FILE      # ends with 0 once the window says that it took the drop

The interpreter by its path: python3-xlib is the distribution's.
"""

import pathlib
import select
import sys
import time

from Xlib import X, Xatom, display
from Xlib.protocol import event

VERSION = 5
PATIENCE = 20.0


class Source:
    """A window that owns what is being dragged."""

    def __init__(self, screen, target):
        self.display = display.Display(screen)
        root = self.display.screen().root
        self.window = root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.target = self.display.create_resource_object("window", target)
        self.uri_list = self.atom("text/uri-list")
        self.window.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)

    def atom(self, name):
        return self.display.intern_atom(name)

    def tell(self, kind, *values):
        words = [self.window.id, *values]
        self.target.send_event(event.ClientMessage(window=self.target, client_type=self.atom(kind),
                                                   data=(32, words + [0] * (5 - len(words)))))
        self.display.flush()

    def next_message(self, content):
        """The target's next message, (kind, words). What it asks for meanwhile it gets: `content`."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if not self.display.pending_events():
                select.select([self.display], [], [], 0.1)
                continue
            came = self.display.next_event()
            if came.type == X.SelectionRequest:
                came.requestor.change_property(came.property, self.uri_list, 8, content)
                came.requestor.send_event(event.SelectionNotify(
                    time=came.time, requestor=came.requestor, selection=came.selection, target=came.target,
                    property=came.property))
                self.display.flush()
            if came.type == X.ClientMessage:
                return self.display.get_atom_name(came.client_type), list(came.data[1])
        raise TimeoutError("the window does not answer")

    def drop(self, x, y, path):
        """Whether the target took it."""
        content = (pathlib.Path(path).resolve().as_uri() + "\r\n").encode("ascii")
        copy = self.atom("XdndActionCopy")
        self.tell("XdndEnter", VERSION << 24, self.uri_list)
        self.tell("XdndPosition", 0, x << 16 | y, X.CurrentTime, copy)
        kind, words = self.next_message(content)
        if kind != "XdndStatus" or not words[1] & 1:
            return False
        self.tell("XdndDrop", 0, X.CurrentTime)
        kind, words = self.next_message(content)
        # GLFW says how many bytes it got where the text wants a 1.
        return kind == "XdndFinished" and words[1] != 0


def main():
    screen, target, x, y, path = sys.argv[1:]
    source = Source(screen, int(target))
    assert source.target.get_full_property(source.atom("XdndAware"), Xatom.ATOM), "the window takes no drops"
    return 0 if source.drop(int(x), int(y), path) else 1


if __name__ == "__main__":
    sys.exit(main())
