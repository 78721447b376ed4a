# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a screen for tests, driven by the W3C's WebDriver protocol through chromedriver: clicks, keys, pictures."""
import base64
import json
import os
import shutil
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.request

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
KEYS = {"down": "\ue015", "up": "\ue013", "tab": "\ue004"}


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Browser:
    """`with Browser(width, height) as b:`; the test is skipped where chromium or its driver is not installed."""

    def __init__(self, width=1280, height=900):
        self.profile = None
        if shutil.which("chromium") is None or shutil.which("chromedriver") is None:
            raise unittest.SkipTest("chromium and chromium-driver are not installed (cmake/setup check)")
        self.profile = tempfile.mkdtemp(prefix="orrery-browser-")
        self.port = free_port()
        self.driver = subprocess.Popen(["chromedriver", f"--port={self.port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 60
        while not self._is_up():
            if time.monotonic() > end:
                self.__exit__()
                raise RuntimeError("chromedriver did not start")
            time.sleep(0.05)
        args = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", f"--user-data-dir={self.profile}", f"--window-size={width},{height}"]
        made = self._call("POST", "/session", {"capabilities": {"alwaysMatch": {"browserName": "chrome", "goog:chromeOptions": {"args": args}, "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.session = f"/session/{made['sessionId']}"

    def _is_up(self):
        try:
            return self._call("GET", "/status")["ready"]
        except OSError:
            return False

    def _call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=90) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as e:
            raise RuntimeError(f"{path}: {e.read().decode()[:400]}") from None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.profile is None:
            return
        try:
            if hasattr(self, "session"):
                self._call("DELETE", self.session)
        finally:
            self.driver.terminate()
            self.driver.wait(30)
            shutil.rmtree(self.profile, True)

    def open(self, url):
        self._call("POST", self.session + "/url", {"url": url})

    def run(self, script, *args):
        return self._call("POST", self.session + "/execute/sync", {"script": script, "args": list(args)})

    def until(self, script, what, patience_s=60):
        """Waits until an expression of the page is true, and returns it."""
        end = time.monotonic() + patience_s
        while True:
            value = self.run("return " + script)
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError(f"the page never had {what}")
            time.sleep(0.1)

    def find(self, selector):
        return self._call("POST", self.session + "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def click(self, selector):
        self._call("POST", f"{self.session}/element/{self.find(selector)}/click", {})

    def press(self, key):
        keys = {"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": KEYS[key]}, {"type": "keyUp", "value": KEYS[key]}]}
        self._call("POST", self.session + "/actions", {"actions": [keys]})

    def resize(self, width, height):
        self._call("POST", self.session + "/window/rect", {"width": width, "height": height})

    def picture(self, path):
        """The whole page as PNG."""
        size = self.run("return [document.documentElement.clientWidth, document.documentElement.scrollHeight]")
        shot = self._call("POST", self.session + "/goog/cdp/execute", {"cmd": "Page.captureScreenshot", "params": {"captureBeyondViewport": True, "clip": {"x": 0, "y": 0, "width": size[0], "height": size[1], "scale": 1}}})
        with open(path, "wb") as f:
            f.write(base64.b64decode(shot["data"]))

    def emulate(self, **features):
        """emulate(prefers_color_scheme="dark"): what the page's style sheet is told of its reader."""
        told = [{"name": k.replace("_", "-"), "value": v} for k, v in features.items()]
        self._call("POST", self.session + "/goog/cdp/execute", {"cmd": "Emulation.setEmulatedMedia", "params": {"features": told}})

    def width(self, pixels, height=900):
        """A window of that width, narrower than a window of a desktop can be too."""
        self._call("POST", self.session + "/goog/cdp/execute", {"cmd": "Emulation.setDeviceMetricsOverride", "params": {"width": pixels, "height": height, "deviceScaleFactor": 1, "mobile": False}})

    def complaints(self):
        """What the page wrote to the browser's console."""
        return [e["message"] for e in self._call("POST", self.session + "/se/log", {"type": "browser"}) if e["level"] in ("SEVERE", "WARNING")]


def keep(browser, name):
    """A picture of the page in the folder ORRERY_PICTURES, where that is set, for people to look at."""
    folder = os.environ.get("ORRERY_PICTURES")
    if folder:
        browser.picture(os.path.join(folder, name))
