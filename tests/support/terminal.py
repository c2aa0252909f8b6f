"""What a program draws on a terminal."""
import fcntl
import os
import pty
import struct
import termios


def drawn_by(start, columns=80):
    """start(stream) starts a process with that standard error, a terminal of so many columns: (the process, still to be
    waited for, and all that it has written there, as bytes)."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("4H", 24, columns, 0, 0))
    process = start(theirs)
    os.close(theirs)
    drawn = b""
    try:
        while part := os.read(ours, 4096):
            drawn += part
    except OSError:  # the other end is closed
        pass
    os.close(ours)
    return process, drawn
