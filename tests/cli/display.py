"""A virtual display, and a person at it: real windows and real key presses."""

import ctypes
import os
import shutil
import subprocess
import time
import unittest

from command import FFMPEG, PROGRAM, CommandTest

needs_display = unittest.skipUnless(FFMPEG and shutil.which("Xvfb") and shutil.which("xdotool"),
                                    "Xvfb, xdotool or ffmpeg is not installed: no window is tested")
PATIENCE = 60  # seconds; a busy machine is slow to open a window


class DisplayTest(CommandTest):
    """A test with a display of its own, on which `view` runs."""

    def setUp(self):
        super().setUp()
        reader, writer = os.pipe()
        server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1400x1000x24", "-noreset"],
                                  pass_fds=[writer], stderr=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        os.close(writer)
        with os.fdopen(reader) as number:
            self.environment = {**os.environ, "DISPLAY": ":" + number.readline().strip()}

    def tool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], env=self.environment, capture_output=True, text=True,
                              timeout=PATIENCE).stdout.strip()

    def wait_for(self, what, condition):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            value = condition()
            if value:
                return value
            time.sleep(0.02)
        self.fail(f"waited in vain for {what}")

    def view(self, *arguments, **keywords):
        self.start_view("--dict", "DICT_4X4_50", "--screenshots", self.path("shots"), *arguments, **keywords)

    def start_view(self, *arguments, **keywords):
        """Starts the program and puts the keyboard into its window."""
        self.viewer = subprocess.Popen([PROGRAM, "view", *map(str, arguments)], env=self.environment,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **keywords)
        self.addCleanup(self.viewer.stderr.close)
        self.addCleanup(self.viewer.stdout.close)
        self.addCleanup(self.viewer.wait)
        self.addCleanup(self.viewer.kill)
        self.window = self.wait_for("a window", lambda: self.tool("search", "--onlyvisible", "--name",
                                                                  "runmark view: ")).split()[0]
        self.tool("windowfocus", "--sync", self.window)

    def close_window(self):
        """What a window manager does when its close button is clicked: it sends WM_DELETE_WINDOW."""
        class ClientMessage(ctypes.Structure):
            _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                        ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                        ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("padding", ctypes.c_long * 24)]
        client_message = 33
        x11 = ctypes.CDLL("libX11.so.6")
        x11.XOpenDisplay.restype = ctypes.c_void_p
        x11.XInternAtom.restype = ctypes.c_ulong
        display = ctypes.c_void_p(x11.XOpenDisplay(self.environment["DISPLAY"].encode()))

        def atom(name):
            return x11.XInternAtom(display, name, 0)
        event = ClientMessage(type=client_message, window=int(self.window), message_type=atom(b"WM_PROTOCOLS"), format=32)
        event.data[0] = atom(b"WM_DELETE_WINDOW")
        x11.XSendEvent(display, ctypes.c_ulong(int(self.window)), 0, ctypes.c_long(0), ctypes.byref(event))
        x11.XCloseDisplay(display)

    def title(self):
        return self.tool("getwindowname", self.window)

    def press(self, key, title=None):
        """Presses a key, and waits until the window's title holds what it should then."""
        self.tool("key", key)
        if title:
            self.wait_for(f"the title {title!r}", lambda: title in self.title())

    def screenshot(self):
        """Width, height and RGB pixels of what the key s saves."""
        self.press("s")
        return self.pixels(self.viewer.stdout.readline().strip())

    def pixels(self, path):
        size = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height", "-of", "csv=p=0", path],
                              check=True, capture_output=True, text=True).stdout
        width, height = map(int, size.split(","))
        data = subprocess.run([FFMPEG, "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                              check=True, capture_output=True).stdout
        return width, height, data

    def screen(self):
        """The same of the whole screen."""
        path = self.path("screen.png")
        subprocess.run([FFMPEG, "-v", "error", "-y", "-f", "x11grab", "-video_size", "1400x1000", "-i",
                        self.environment["DISPLAY"], "-frames:v", "1", path], check=True)
        return self.pixels(path)

    def expect_end(self, status):
        self.assertEqual(self.viewer.wait(timeout=PATIENCE), status)
