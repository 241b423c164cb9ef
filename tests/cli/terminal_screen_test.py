#!/usr/bin/env python3
"""What the command writes to a terminal: ASCII where its locale has no other letters, colours unless
NO_COLOR asks for none, lines of progress that fit; and to a pipe every byte as it is.

terminal_screen_test.py COMMAND DATA
"""

import fcntl
import os
import pty
import re
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest

COMMAND, DATA = os.path.abspath(sys.argv[1]), sys.argv[2]
COLOUR = re.compile(rb"\x1b\[[0-9;]*m")


def on_terminal(*words, columns=60, stop_after=None, **environment):
    """Runs the command on a terminal of its own. @return what it wrote, and its exit code"""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    names = {**os.environ, "TERM": "xterm", "LC_ALL": "C.UTF-8", **environment}
    names = {name: value for name, value in names.items() if value is not None}
    process = subprocess.Popen([COMMAND, *words], stdin=theirs, stdout=theirs, stderr=theirs,
                               env=names, start_new_session=True)
    os.close(theirs)
    begin = time.monotonic()
    written = b""
    while True:
        try:
            more = os.read(ours, 65536)
        except OSError:  # the other end is closed
            break
        if not more:
            break
        written += more
        if stop_after is not None and time.monotonic() - begin > stop_after:
            process.send_signal(signal.SIGINT)
            stop_after = None
    os.close(ours)
    return written, process.wait()


class Terminal(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.fit = os.path.join(cls.folder.name, "fit.h5")
        subprocess.run([COMMAND, "calibrate", os.path.join(DATA, "fits/demo.toml"), "-o", cls.fit],
                       check=True, capture_output=True)

    def test_plain_letters_where_the_locale_has_no_others(self):
        for words in (("show", self.fit, "--all"), ("plot", self.fit), ("help", "plot")):
            with self.subTest(words):
                plain, code = on_terminal(*words, columns=120, LC_ALL="C")
                self.assertEqual(code, 0)
                self.assertEqual([byte for byte in plain if byte > 126], [])
                self.assertNotIn(b"?", plain)
                letters, _ = on_terminal(*words, columns=120)
                self.assertEqual(plain.count(b"\n"), letters.count(b"\n"))
        letters, _ = on_terminal("show", self.fit)
        self.assertIn("±", letters.decode())

    def test_a_pipe_gets_every_byte_in_any_locale(self):
        texts = [subprocess.run([COMMAND, "show", self.fit, "--all"], check=True, capture_output=True,
                                env={**os.environ, "LC_ALL": locale}).stdout
                 for locale in ("C", "C.UTF-8")]
        self.assertEqual(*texts)
        self.assertIn("±", texts[0].decode())
        self.assertIsNone(COLOUR.search(texts[0]))

    def test_colours_are_what_the_user_wants(self):
        self.assertIsNotNone(COLOUR.search(on_terminal("show", self.fit, NO_COLOR=None)[0]))
        self.assertIsNotNone(COLOUR.search(on_terminal("show", self.fit, NO_COLOR="")[0]))
        self.assertIsNone(COLOUR.search(on_terminal("show", self.fit, NO_COLOR="1")[0]))
        self.assertIsNone(COLOUR.search(on_terminal("show", self.fit, TERM="dumb")[0]))

    def test_reports_and_pictures_fit(self):
        for columns in (60, 72, 99):
            for words in (("show", self.fit, "--all"), ("plot", self.fit)):
                written, code = on_terminal(*words, columns=columns, NO_COLOR="1")
                self.assertEqual(code, 0)
                lines = written.decode().splitlines()
                self.assertLessEqual(max(map(len, lines)), columns, words)
        wide, _ = on_terminal("show", self.fit, "--all", columns=100, NO_COLOR="1")
        piped = subprocess.run([COMMAND, "show", self.fit, "--all"], check=True,
                               capture_output=True).stdout
        self.assertEqual(wide.replace(b"\r\n", b"\n"), piped)

    def test_progress_fits_into_the_line(self):
        scene = os.path.join(self.folder.name, "scene.toml")
        with open(os.path.join(DATA, "scenes/falling_cantilever.toml"), encoding="utf-8") as file:
            text = file.read()
        text = re.sub(r"(?m)^segments *=.*$", "segments = 400", text)
        with open(scene, "w", encoding="utf-8") as file:
            file.write(text)
        for columns in (60, 24):
            written, code = on_terminal("simulate", scene, "-o", scene + f"{columns}.h5",
                                        columns=columns, stop_after=3.0)
            drawn = re.findall(rb"\r([^\r\n]*)\x1b\[K", written)
            self.assertGreater(len(drawn), 2)
            for line in drawn:
                self.assertLess(len(line.decode()), columns, line)
            self.assertIn(code, (0, 130))

    def test_progress_of_an_export_fits_into_the_line(self):
        """Frames that are written: it rises to all of them, and is wiped."""
        scene = os.path.join(self.folder.name, "export.toml")
        with open(os.path.join(DATA, "scenes/crash_bumper.toml"), encoding="utf-8") as file:
            text = file.read()
        with open(scene, "w", encoding="utf-8") as file:
            file.write(re.sub(r"(?m)^frames *=.*$", "frames = 400", text))
        result, shown = scene + ".h5", scene + ".vtkhdf"
        subprocess.run([COMMAND, "simulate", scene, "-o", result], check=True, capture_output=True)
        for columns in (60, 24):
            written, code = on_terminal("export", result, "-o", shown, "--force", columns=columns,
                                        LC_ALL="C")
            self.assertEqual(code, 0)
            drawn = re.findall(rb"\r([^\r\n]*)\x1b\[K", written)
            self.assertEqual(drawn.pop(), b"", written)
            self.assertGreater(len(drawn), 0)
            for line in drawn:
                self.assertLess(len(line), columns, line)
                self.assertEqual([byte for byte in line if byte > 126], [])
            self.assertTrue(drawn[0].startswith(b"frames ["), drawn[0])
        piped = subprocess.run([COMMAND, "export", result, "-o", shown, "--force"], check=True,
                               capture_output=True)
        self.assertEqual(piped.stdout + piped.stderr, b"")

    def test_help_is_where_one_looks_for_it(self):
        alone = on_terminal()[0]
        self.assertIn(b"calibrate", alone)
        for words in (("help",), ("--help",)):
            self.assertEqual(on_terminal(*words), (alone, 0))
        self.assertEqual(on_terminal("help", "plot"), on_terminal("plot", "--help"))
        self.assertEqual(on_terminal("-V"), on_terminal("--version"))
        written, code = on_terminal("help", "nosuch")
        self.assertEqual((code, written.count(b"\n")), (2, 1))

    def complete(self, *words):
        """What bash would offer for the last of the words."""
        script = ("source <(\"$0\" completion bash); COMP_WORDS=(\"$@\"); "
                  "COMP_CWORD=$(($# - 1)); _plastica; printf '%s\\n' \"${COMPREPLY[@]}\"")
        done = subprocess.run(["bash", "-uc", script, COMMAND, *words], capture_output=True,
                              text=True, cwd=DATA, check=True)
        return done.stdout.split()

    def test_bash_completes(self):
        self.assertEqual(self.complete("plastica", "cali"), ["calibrate"])
        self.assertEqual(self.complete("plastica", "help", "rep"), ["report"])
        self.assertEqual(self.complete("plastica", "plot", "--wh"), ["--what"])
        self.assertIn("--output", self.complete("plastica", "sweep", "-"))
        self.assertEqual(self.complete("plastica", "simulate", "scenes/cant"),
                         ["scenes/cantilever.toml"])
        for shell in ("zsh", "fish"):
            script = on_terminal("completion", shell, columns=500)[0]
            for name in (b"calibrate", b"report", b"resume"):
                self.assertIn(name, script)
        self.assertEqual(on_terminal("completion", "tcsh")[1], 2)

    def test_man_pages_have_what_the_help_has(self):
        commands = re.findall(r"(?m)^  ([a-z]+)  ", on_terminal("--help")[0].decode())
        self.assertGreater(len(commands), 15)
        for command in commands:
            page, code = on_terminal("man", command, columns=500)
            self.assertEqual(code, 0)
            page = page.decode().replace("\\-", "-")
            self.assertIn(f"plastica-{command}", page)
            options = re.findall(r"--[a-z][a-z-]+", on_terminal("help", command, columns=500)[0].decode())
            for option in options:
                self.assertIn(option, page)
        self.assertEqual(on_terminal("man", "nosuch")[1], 2)

    def test_fields_are_searched(self):
        lines = on_terminal("fields", "YIELD", "stress", columns=200)[0].splitlines()
        self.assertTrue(lines[1].startswith(b"material.yield_stress "), lines)
        for line in lines[1:]:
            self.assertRegex(line.lower(), b"yield.*stress|stress.*yield")
        self.assertEqual(on_terminal("fields", "nosuch")[1], 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
