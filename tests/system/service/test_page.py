#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The live page: what it is told is what the protocol answers, nobody else's page may read it, and it does what it shows in a browser."""
import http.client
import json
import re
import shutil
import subprocess
import time
import unittest
import urllib.parse

from daemon import ORRERY, ROOT, WORK, Daemon, orrery, product  # first: it sets the path

from browser import Browser, keep
from test_streams import SCENARIO

PAGE = ROOT / "src/service/http/live_page.html"


class Served(unittest.TestCase):
    daemon = None

    @classmethod
    def setUpClass(cls):
        if Served.daemon is None:
            product()
            shutil.copy(ROOT / "samples/ionosphere.ION", WORK)
            (WORK / "page.yaml").write_text(SCENARIO + "imu: {rate: 100}\n", encoding="utf-8")
            Served.daemon = Daemon(WORK / "page.yaml", "--http", "127.0.0.1:0", "--from", "2025-03-21T10:02:00")
        cls.url = next(u for u in cls.daemon.urls if u.startswith("http://"))
        cls.port = int(urllib.parse.urlsplit(cls.url).port)


def tearDownModule():
    assert Served.daemon.stop() == 0


class Http(Served):
    def get(self, path, method="GET", host=None, **headers):
        c = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        try:
            c.putrequest(method, path, skip_host=True)
            c.putheader("Host", host or f"127.0.0.1:{self.port}")
            for k, v in headers.items():
                c.putheader(k, v)
            c.endheaders()
            answer = c.getresponse()
            return answer.status, answer.headers, answer.read().decode()
        finally:
            c.close()

    def ask(self, **request):
        status, _, text = self.get("/ask?" + urllib.parse.quote(json.dumps(request)))
        self.assertEqual(status, 200)
        return [json.loads(line) for line in text.splitlines()]

    def events(self, query="", n=1):
        """Connects for events and reads the first n of each kind."""
        c = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        c.request("GET", "/events" + query)
        answer, got, name = c.getresponse(), {}, None
        self.assertEqual(answer.status, 200)
        self.assertEqual(answer.headers["Content-Type"], "text/event-stream")
        while len(got.get("clients", [])) < n:
            line = answer.readline().decode().rstrip("\n")
            if line.startswith("event: "):
                name = line[7:]
            elif line.startswith("data: "):
                got.setdefault(name, []).append(json.loads(line[6:]))
        return c, got

    def test_the_page_is_the_file_and_keeps_to_itself(self):
        status, head, text = self.get("/")
        self.assertEqual((status, text), (200, PAGE.read_text(encoding="utf-8")))
        self.assertIn("default-src 'none'", head["Content-Security-Policy"])
        self.assertEqual(head["X-Content-Type-Options"], "nosniff")
        outside = [u for u in re.findall(r"""(?:https?:)?//[\w.]+[^\s"'`]*""", text) if "://www.w3.org/2000/svg" in u or "://" in u]
        self.assertEqual(outside, ["http://www.w3.org/2000/svg"])  # a name, which nothing is read from

    def test_others_are_refused(self):
        for host in ("example.com", f"example.com:{self.port}", f"127.0.0.1.example.com:{self.port}", "127.0.0.1:1"):
            self.assertEqual(self.get("/caps", host=host)[0], 403, host)
        for origin in ("http://example.com", "null", f"https://127.0.0.1:{self.port}", f"http://localhost:{self.port}.example.com"):
            self.assertEqual(self.get("/caps", Origin=origin)[0], 403, origin)
        self.assertEqual(self.get("/caps", Origin=f"http://localhost:{self.port}")[0], 200)
        self.assertEqual(self.get("/nothing")[0], 404)
        for method in ("POST", "PUT", "DELETE"):
            self.assertGreaterEqual(self.get("/caps", method=method, **{"Content-Length": "0"})[0], 400, method)

    def test_it_reads_only(self):
        self.assertEqual(self.ask(request="CONTROL", action="STOP")[0]["error"], "NOT_PERMITTED")
        self.assertEqual(self.ask(request="GET_TIME")[0]["state"], "RUNNING")
        self.assertEqual(self.ask(request="POLL", count=601, step=10**9)[0]["error"], "LIMIT")
        self.assertEqual(len(self.ask(request="POLL", t="2025-03-21T10:00:00", count=600, step=10**9)), 600)

    def test_events_are_what_the_protocol_answers(self):
        c, got = self.events("?antenna=1&unit=0")
        c.close()
        told = got["channels"][0]
        polled = self.ask(request="POLL_CHANNELS", t=told["t_gps"], antenna=1, terms=1)[0]
        self.assertEqual(told, polled)
        self.assertEqual(told["antenna"], 1)
        self.assertGreater(len(told["channels"]), 3)
        truth = got["truth"][0]
        self.assertEqual(truth, self.ask(request="POLL_TRUTH", t=truth["t_gps"])[0])
        caps = json.loads(self.get("/caps")[2])
        self.assertIn("POLL_CHANNELS", [r["request"] for r in caps["requests"]])

    def test_clients_and_their_streams(self):
        log = WORK / "page.log"
        with subprocess.Popen([ORRERY, "record", self.daemon.urls[0], "-o", log, "--channels", "--count", "100000", "--lead", "0.3"], stderr=subprocess.DEVNULL) as p:
            try:
                end = time.monotonic() + 60
                clients = []
                while not (clients and clients[0]["streams"] and clients[0]["streams"][0]["blocks"] > 5) and time.monotonic() < end:
                    c, got = self.events(n=2)
                    c.close()
                    clients = got["clients"][-1]["clients"]
                self.assertEqual(len(clients), 1)
                self.assertTrue(clients[0]["name"].startswith("orrery record"))
                stream = clients[0]["streams"][0]
                self.assertEqual((stream["request"], stream["pacing"], stream["lead_s"]), ("POLL_CHANNELS", "CLOCK", 0.3))
                self.assertLessEqual(stream["least_s"], stream["margin_s"])
                self.assertLessEqual(stream["margin_s"], 0.3)
            finally:
                p.terminate()
                p.wait(30)

    def test_pages_have_a_limit(self):
        open_now = []
        try:
            for _ in range(16):
                open_now.append(self.events()[0])
            c = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
            c.request("GET", "/events")
            self.assertEqual(c.getresponse().status, 503)
            c.close()
            self.assertEqual(self.get("/caps")[0], 200)
        finally:
            for c in open_now:
                c.close()
        end = time.monotonic() + 30
        while time.monotonic() < end:  # places become free when their connections are gone
            c = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
            c.request("GET", "/events")
            status = c.getresponse().status
            c.close()
            if status == 200:
                return
            time.sleep(0.1)
        self.fail("no place became free")

    def test_other_machines_are_no_address(self):
        for address in ("0.0.0.0:8080", "*:8080", "127.0.0.1"):
            done = orrery("serve", WORK / "page.yaml", "--listen", "tcp://127.0.0.1:0", "--http", address)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("on this machine alone", done.stderr)


class Page(Served):
    def test_in_a_browser(self):
        with Browser() as b:
            b.width(1280)
            b.open(self.url)
            b.until("document.querySelectorAll('#sats tbody tr[tabindex]').length > 3", "satellites")
            chosen = b.until("shape.chosen", "a chosen satellite")
            other = b.run("return [...document.querySelectorAll('#sky .sat')].map(g => g.dataset.sat).find(s => s !== arguments[0])", chosen)
            b.click(f'#sky .sat[data-sat="{other}"]')
            self.assertEqual(b.run("return document.getElementById('chosen').textContent"), other)
            self.assertEqual(b.run("return document.querySelector('#sats tr[aria-selected=true]').dataset.sat"), other)
            sum_m = b.run("const c = shape.channels, k = c.channels.findIndex(x => x.sat === shape.chosen); let s = 0; for (const [n, v] of Object.entries(c.terms[k])) if (!['wind_up_m', 'phase_bias_m', 'echo_phase_m'].includes(n)) s += v; return s - c.channels[k].code[0]")
            self.assertLess(abs(sum_m), 1e-6)
            # Terms that are nothing stand in the table when they are asked for.
            short, whole = b.run("const c = shape.channels, k = c.channels.findIndex(x => x.sat === shape.chosen), v = Object.values(c.terms[k]); return [v.filter(x => Math.abs(x) >= 5e-4).length, v.length]")
            self.assertLess(short, whole)
            self.assertEqual(b.run("return document.querySelectorAll('#terms tr').length"), short + 2)  # a head and the sum
            b.click("#all-terms")
            self.assertEqual(b.run("return document.querySelectorAll('#terms tr').length"), whole + 2)
            b.click("#all-terms")
            rows = b.run("return [...document.querySelectorAll('#sats tr[tabindex]')].map(r => r.dataset.sat)")
            b.click(f'#sats tr[data-sat="{rows[0]}"]')
            b.press("down")
            self.assertEqual(b.run("return shape.chosen"), rows[1])
            self.assertEqual(b.run("return document.activeElement.dataset.sat"), rows[1])
            b.press("up")
            self.assertEqual(b.run("return shape.chosen"), rows[0])
            b.until("Object.values(shape.tracks).some(t => t.length > 10)", "tracks")
            b.until("shape.imu.length > 100", "inertial readings")
            b.until("shape.path.length > 300", "the trajectory")
            for name in ("rate-plot", "force-plot", "map", "clock-plot"):
                b.until(f"(() => {{ const c = document.getElementById('{name}'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; return d.some(v => v > 0); }})()", name)
            self.assertEqual(b.run("return document.getElementById('signal').options.length"), 4)
            b.run("const s = document.getElementById('signal'); s.value = s.options[1].value; s.onchange()")
            self.assertEqual(b.run("return [...new Set([...document.querySelectorAll('#sats tbody tr td:nth-child(4)')].map(t => t.textContent))]"), ["L1CA"])
            self.assertRegex(b.run("return document.getElementById('sat-count').textContent"), r"^\d of \d in view send this signal$")
            b.until("shape.until", "what the scenario says will happen")
            ahead = b.run("return [shape.from, shape.until, shape.ahead.map(e => e.at)]")
            self.assertEqual(ahead[1] - ahead[0], 600000)
            self.assertTrue(b.run("return shape.caps.requests.some(r => r.request === 'POLL_EVENTS')"))
            keep(b, "wide.png")
            light = b.run("return getComputedStyle(document.body).backgroundColor")
            b.emulate(prefers_color_scheme="dark")
            dark = b.run("return getComputedStyle(document.body).backgroundColor")
            self.assertGreater(sum(map(int, re.findall(r"\d+", light))), 3 * sum(map(int, re.findall(r"\d+", dark))))
            blue = b.run("return getComputedStyle(document.documentElement).getPropertyValue('--c0').trim()")
            b.until("(() => { const k = document.getElementById('rate-plot'), c = document.createElement('canvas'); c.width = k.width; c.height = k.height; const g = c.getContext('2d', { willReadFrequently: true }); g.fillStyle = '%s'; g.fillRect(0, 0, 1, 1); const want = g.getImageData(0, 0, 1, 1).data; g.clearRect(0, 0, 1, 1); g.drawImage(k, 0, 0); const d = g.getImageData(0, 0, c.width, c.height).data; for (let i = 0; i < d.length; i += 4) if (d[i + 3] === 255 && d[i] === want[0] && d[i + 1] === want[1] && d[i + 2] === want[2]) return true; return false; })()" % blue, "curves in the dark's colours")
            keep(b, "dark.png")
            for width in (1280, 800, 400, 320):
                b.width(width)
                self.assertLessEqual(b.run("return document.documentElement.scrollWidth"), width)
            b.width(400)
            keep(b, "narrow.png")
            at = "const t = shape.time; shape.time = { ...t, t_gps: arguments[0] }; const why = whyNothing(); shape.time = t; return why"
            self.assertEqual(b.run(at, "2025-03-20T23:00:00.0"), "The motion begins at 2025-03-21 10:00:00 GPS.")
            self.assertEqual(b.run(at, "2025-03-21T10:05:00.0"), "")
            self.assertEqual(b.run(at, "2025-03-21T10:11:00.0"), "The motion ended at 2025-03-21 10:10:00 GPS.")
            read = b.run("return performance.getEntriesByType('resource').map(e => e.name)")
            self.assertTrue(all(u.startswith(self.url) for u in read), read)
            self.assertEqual(b.complaints(), [])


if __name__ == "__main__":
    unittest.main(argv=["test_page.py"])
