#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`orrery fetch` against a server on loopback that is good, slow, broken, redirecting, empty-handed, or answers with web pages
and half files. Usage: fetch.py PATH_OF_ORRERY [unittest arguments]."""
import base64
import gzip
import hashlib
import http.server
import json
import os
import pathlib
import shutil
import signal
import ssl
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "fuzz"))
import make_product_seeds as made  # noqa: E402

ORRERY = sys.argv.pop(1) if len(sys.argv) > 1 else "orrery"
DAY = "2024-02-04"
NAME = "made035.24i.gz"


def noise(n):
    """Comment lines that do not compress: a file that takes several packets."""
    text = "".join(hashlib.sha256(str(k).encode()).hexdigest()[:60].ljust(60) + "COMMENT\n" for k in range(n))
    return text


IONEX = gzip.compress(made.ionex(extra=noise(3000)).encode(), mtime=0)
OTHER_DAY = gzip.compress(made.ionex().replace("2024     2     4", "2023     2     4").encode(), mtime=0)
PAGE = b"<!DOCTYPE html>\n<html><head><title>Sign in</title></head><body>Please sign in.</body></html>\n"


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def log_message(self, *args):
        pass

    def send(self, status, body, length=None, **headers):
        self.send_response(status)
        self.send_header("Content-Length", str(len(body) if length is None else length))
        for key, value in headers.items():
            self.send_header(key.replace("_", "-"), value)
        self.end_headers()
        self.wfile.write(body)

    def give(self, data, upto=None):
        """The data, from where Range says, but no more than `upto` bytes of them."""
        start = 0
        asked = self.headers.get("Range")
        if asked:
            start = int(asked.split("=")[1].split("-")[0])
            if start >= len(data):
                self.send(416, b"")
                return
        body = data[start:]
        sent = body if upto is None else body[:upto]
        headers = {"Content_Range": f"bytes {start}-{len(data) - 1}/{len(data)}"} if asked else {}
        self.send(206 if asked else 200, sent, length=len(body), **headers)
        if upto is not None and len(sent) < len(body):
            self.wfile.flush()
            self.close_connection = True

    def do_GET(self):
        server = self.server
        what = self.path.split("/")[1]
        with server.lock:
            server.seen.append((what, self.path, self.headers.get("Range")))
            count = sum(1 for s in server.seen if s[0] == what)
        data = server.files.get(self.path.rsplit("/", 1)[1].split("?")[0])
        if what == "good":
            self.send(404, b"no such file") if data is None else self.give(data)
        elif what == "missing":
            self.send(404, PAGE)
        elif what == "forbidden":
            self.send(403, PAGE)
        elif what == "html":
            self.send(200, PAGE)
        elif what == "busy":
            self.send(503, b"later") if count <= 2 else self.give(data)
        elif what == "broken":  # breaks off in the middle every time, but resumes
            self.give(data, upto=len(data) // 3 + 1)
        elif what == "deaf":  # breaks off once, and does not know Range
            if count == 1:
                self.give(data, upto=len(data) // 2)
            else:
                self.send(200, data)
        elif what == "cut":  # a half file that claims to be whole
            self.send(200, data[: len(data) // 2])
        elif what == "cutonce":
            self.send(200, data[: len(data) // 2] if count == 1 else data)
        elif what == "empty":
            self.send(200, b"")
        elif what == "otherday":
            self.send(200, OTHER_DAY)
        elif what == "slow":  # a little, then silence; the next time all the rest
            if count == 1:
                self.send(200, data[:5000], length=len(data))
                self.wfile.flush()
                server.quiet.wait(20)
                self.close_connection = True
            else:
                self.give(data)
        elif what == "trickle":  # in pieces, for programs side by side
            self.send(200, data[:1000], length=len(data))
            for at in range(1000, len(data), len(data) // 5):
                self.wfile.flush()
                time.sleep(0.1)
                self.wfile.write(data[at:at + len(data) // 5])
        elif what == "redirect":
            self.send(302, b"", Location=self.path.replace("/redirect/", "/good/"))
        elif what == "plain":  # from https to a server without it
            self.send(302, b"", Location=f"http://127.0.0.1:{server.plain_port}{self.path.replace('/plain/', '/good/')}")
        elif what == "elsewhere":  # to another host's https
            self.send(302, b"", Location=f"https://localhost:{server.server_port}{self.path.replace('/elsewhere/', '/good/')}")
        elif what == "circle":
            self.send(302, b"", Location=self.path)
        elif what == "login":  # like Earthdata: sent to the login host, back with a cookie
            if "session=yes" in (self.headers.get("Cookie") or ""):
                self.give(data)
            else:
                self.send(302, b"", Location=f"http://localhost:{server.server_port}/urs{self.path}")
        elif what == "urs":
            expected = "Basic " + base64.b64encode(b"ada:secret").decode()
            if self.headers.get("Authorization") != expected:
                self.send(401, PAGE, WWW_Authenticate='Basic realm="login"')
            else:
                self.send(302, b"", Location=f"http://127.0.0.1:{server.server_port}/token/{NAME}")
        elif what == "token":
            self.send(302, b"", Location=f"/login/{NAME}", Set_Cookie="session=yes; Path=/")
        else:
            self.send(500, b"?")


class Server(http.server.ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self):
        super().__init__(("127.0.0.1", 0), Handler)
        self.files = {NAME: IONEX}
        self.seen, self.lock, self.quiet = [], threading.Lock(), threading.Event()

    def handle_error(self, request, client_address):
        pass  # clients that hang up are part of the play


def certificate(folder):
    """A certificate of 127.0.0.1 and localhost that signs itself, and its key."""
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2",
                    "-subj", "/CN=localhost", "-addext", "subjectAltName=IP:127.0.0.1,DNS:localhost",
                    "-keyout", f"{folder}/key.pem", "-out", f"{folder}/cert.pem"], check=True, capture_output=True, timeout=30)
    return f"{folder}/cert.pem", f"{folder}/key.pem"


class Fetch(unittest.TestCase):
    def setUp(self):
        self.server = Server()
        self.thread = threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True)
        self.thread.start()
        self.folder = tempfile.TemporaryDirectory()
        self.cache = pathlib.Path(self.folder.name) / "cache"

    def tearDown(self):
        self.server.quiet.set()
        self.server.shutdown()
        self.server.server_close()
        self.folder.cleanup()

    def table(self, *mirrors, names=None, extra=""):
        path = pathlib.Path(self.folder.name) / "archives.txt"
        lines = names or [f"name ionex COD final - - {NAME}"]
        lines += [f"mirror {m} * http://127.0.0.1:{self.server.server_port}/{m}/{' login' if m == 'login' else ''}" for m in mirrors]
        path.write_text("\n".join(lines) + "\n" + extra)
        return path

    def command(self, *args, stall="20"):
        return [ORRERY, "fetch", DAY, "--products", "ionex", "--cache", str(self.cache), "--archives",
                str(pathlib.Path(self.folder.name) / "archives.txt"), "--backoff", "0.05", "--stall", stall, *args]

    def run_fetch(self, *args, expect=0, stall="20"):
        env = dict(os.environ, HOME=self.folder.name, no_proxy="*")
        r = subprocess.run(self.command(*args, stall=stall), capture_output=True, text=True, timeout=60, env=env)
        self.assertEqual(r.returncode, expect, r.stderr + r.stdout)
        return r

    def run_fetch_of(self, day, products):
        command = self.command()
        command[2], command[4] = day, products
        r = subprocess.run(command, capture_output=True, text=True, timeout=60, env=dict(os.environ, HOME=self.folder.name, no_proxy="*"))
        self.assertEqual(r.returncode, 0, r.stderr)
        return r

    def place(self, name=NAME):
        return self.cache / "2024" / "035" / name

    def assert_fetched(self, r, data=IONEX, name=NAME):
        self.assertEqual(r.stdout.strip(), str(self.place(name)))
        self.assertEqual(self.place(name).read_bytes(), data)
        self.assertEqual(list(self.cache.rglob("*.part")), [])
        index = (self.cache / "index.tsv").read_text()
        self.assertIn(f"2024/035/{name}\t{len(data)}\t{hashlib.sha256(data).hexdigest()}\t", index)

    def asked(self, what):
        return [s for s in self.server.seen if s[0] == what]

    def test_good(self):
        self.table("good")
        self.assert_fetched(self.run_fetch())
        # The second time nobody is asked.
        before = len(self.server.seen)
        r = self.run_fetch("--format", "json")
        self.assertEqual(len(self.server.seen), before)
        item = json.loads(r.stdout)[0]
        self.assertTrue(item["cached"])
        self.assertEqual(item["sha256"], hashlib.sha256(IONEX).hexdigest())
        self.assertEqual(item["tier"], "final")

    def test_several_at_once(self):
        """Programs side by side on one cache: one fetches, the others wait for it, and all have the whole file."""
        self.table("trickle")
        env = dict(os.environ, HOME=self.folder.name, no_proxy="*")
        runs = [subprocess.Popen(self.command(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=env) for _ in range(4)]
        for r in runs:
            out, err = r.communicate(timeout=60)
            self.assertEqual((r.returncode, out.strip()), (0, str(self.place())), err)
        self.assertEqual(self.place().read_bytes(), IONEX)
        self.assertEqual(len(self.asked("trickle")), 1)
        self.assertEqual(list(self.cache.rglob("*.part")), [])
        index = (self.cache / "index.tsv").read_text()
        self.assertEqual(index.count(hashlib.sha256(IONEX).hexdigest()), 1)

    def test_one_antenna_table_for_all_days(self):
        antex = gzip.compress((pathlib.Path(made.__file__).parent / "corpus/antex/plain").read_bytes())
        self.server.files["igs.atx.gz"] = antex
        self.table("good", names=["name antex IGS - 2022-11-27 - igs.atx.gz start=name"])
        for day in ("2024-02-04", "2025-01-01"):
            r = self.run_fetch_of(day, "antex")
            self.assertEqual(r.stdout.strip(), str(self.cache / "2022/331/igs.atx.gz"))
        self.assertEqual(len(self.asked("good")), 1)

    def test_missing_then_good(self):
        self.table("missing", "forbidden", "good")
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("made035.24i.gz from missing: not there (404); trying made035.24i.gz from forbidden", r.stderr)
        self.assertIn("refused (403)", r.stderr)
        self.assertEqual(len(self.asked("missing")), 1)  # a 404 is not asked twice

    def test_missing_everywhere(self):
        self.table("missing")
        r = self.run_fetch(expect=1)
        self.assertEqual(r.stdout, "")
        self.assertIn("ionex of 2024-02-04", r.stderr)
        self.assertIn("404", r.stderr)
        self.assertFalse(self.place().exists())

    def test_web_page(self):
        self.table("html", "good")
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("web page", r.stderr)

    def test_empty_answer(self):
        self.table("empty", "good")
        self.assert_fetched(self.run_fetch())

    def test_busy(self):
        self.table("busy")
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("busy or broken (503); attempt 2 of 3", r.stderr)
        self.assertEqual(len(self.asked("busy")), 3)

    def test_broken_is_resumed(self):
        self.table("broken")
        r = self.run_fetch("--verbose")
        self.assert_fetched(r)
        ranges = [s[2] for s in self.asked("broken")]
        self.assertIsNone(ranges[0])
        self.assertEqual(ranges[1], f"bytes={len(IONEX) // 3 + 1}-")
        self.assertIn("resumed at byte", r.stderr)

    def test_server_without_ranges(self):
        self.table("deaf")
        self.assert_fetched(self.run_fetch())

    def test_half_file_that_claims_to_be_whole(self):
        self.table("cut", "good")
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("not usable", r.stderr)

    def test_half_file_once(self):
        self.table("cutonce")
        self.assert_fetched(self.run_fetch())

    def test_another_day(self):
        self.table("otherday", "good")
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("another day", r.stderr)

    def test_another_kind(self):
        self.server.files[NAME] = gzip.compress(made.ERP_IGS.encode(), mtime=0)
        self.table("good")
        r = self.run_fetch(expect=1)
        self.assertIn("Earth rotation", r.stderr)

    def test_redirect(self):
        self.table("redirect")
        self.assert_fetched(self.run_fetch())

    def secure_server(self):
        """A second server, behind TLS, that knows the first as the one without."""
        if shutil.which("openssl") is None:
            self.skipTest("needs openssl to make a certificate")
        cert, key = certificate(self.folder.name)
        secure = Server()
        secure.plain_port = self.server.server_port
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(cert, key)
        secure.socket = context.wrap_socket(secure.socket, server_side=True)
        thread = threading.Thread(target=secure.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True)
        thread.start()
        self.addCleanup(secure.server_close)
        self.addCleanup(secure.shutdown)
        self.addCleanup(secure.quiet.set)
        return secure, cert

    def run_securely(self, secure, cert, what, login=False, expect=0, variable="CURL_CA_BUNDLE"):
        names = [f"name ionex COD final - - {NAME}", f"mirror {what} * https://127.0.0.1:{secure.server_port}/{what}/{' login' * login}"]
        self.table(names=names)
        netrc = pathlib.Path(self.folder.name) / ".netrc"
        netrc.write_text("machine 127.0.0.1 login ada password secret\n")
        netrc.chmod(0o600)
        env = dict(os.environ, HOME=self.folder.name, no_proxy="*")
        for name in ("CURL_CA_BUNDLE", "SSL_CERT_FILE", "SSL_CERT_DIR"):
            env.pop(name, None)
        if cert is not None and variable is not None:
            env[variable] = cert
        option = ["--ca-file", cert] if variable is None else []
        r = subprocess.run(self.command(*option), capture_output=True, text=True, timeout=60, env=env)
        self.assertEqual(r.returncode, expect, r.stderr + r.stdout)
        return r

    def test_https(self):
        """TLS with a certificate that option or environment names; without it nobody vouches for the server, and nothing is fetched."""
        secure, cert = self.secure_server()
        r = self.run_securely(secure, None, "good", expect=1)
        self.assertIn("--ca-file", r.stderr)
        self.assertFalse(self.place().exists())
        self.assertEqual(secure.seen, [])  # not even asked
        for variable in (None, "CURL_CA_BUNDLE", "SSL_CERT_FILE"):
            self.assert_fetched(self.run_securely(secure, cert, "good", variable=variable))
            self.place().unlink()

    def test_https_redirects_are_followed(self):
        for what in ("redirect", "elsewhere"):
            for login in (False, True):
                with self.subTest(what, login=login):
                    secure, cert = self.secure_server()
                    self.assert_fetched(self.run_securely(secure, cert, what, login))
                    self.place().unlink()

    def test_a_login_is_never_redirected_to_plain_http(self):
        secure, cert = self.secure_server()
        r = self.run_securely(secure, cert, "plain", login=True, expect=1)
        self.assertIn("another protocol than https while a login is sent", r.stderr)
        self.assertEqual(self.server.seen, [])  # where nothing is encrypted nobody was asked
        self.assertFalse(self.place().exists())
        # Without a login there is nothing to lose: the product's hash and content are checked as ever.
        self.assert_fetched(self.run_securely(secure, cert, "plain"))
        self.assertEqual(len(self.server.seen), 1)

    def test_redirected_in_circles(self):
        self.table("circle", "good")
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("circles", r.stderr)

    def test_slow_is_given_up_and_resumed(self):
        self.table("slow")
        r = self.run_fetch(stall="1")
        self.assert_fetched(r)
        self.assertIn("too slow", r.stderr)
        self.assertEqual(self.asked("slow")[1][2], "bytes=5000-")

    def test_nobody_there(self):
        names = [f"name ionex COD final - - {NAME}"]
        self.table("good", names=names + ["mirror gone * http://127.0.0.1:1/"])
        r = self.run_fetch("--to", "2024-02-04")
        self.assert_fetched(r)
        self.assertIn("from gone", r.stderr)

    def test_login(self):
        self.table("login")
        netrc = pathlib.Path(self.folder.name) / ".netrc"
        self.assertIn("401", self.run_fetch(expect=1).stderr)
        netrc.write_text("machine localhost login ada password secret\n")
        netrc.chmod(0o600)
        self.assert_fetched(self.run_fetch())
        jar = self.cache / "cookies.txt"
        self.assertEqual(jar.stat().st_mode & 0o077, 0)
        # The cookie serves the next file: nobody logs in again.
        self.place().unlink()
        logins = len(self.asked("urs"))
        self.run_fetch()
        self.assertEqual(len(self.asked("urs")), logins)

    def test_tiers(self):
        self.server.files = {"rapid.24i.gz": IONEX}
        self.table("good", names=["name ionex COD final - - final.24i.gz", "name ionex COD rapid - - rapid.24i.gz"])
        r = self.run_fetch()
        self.assert_fetched(r, name="rapid.24i.gz")
        self.assertIn("trying rapid.24i.gz from good, tier rapid", r.stderr)
        self.server.seen.clear()
        self.run_fetch("--tier", "rapid")
        self.assertEqual(self.server.seen, [])  # in the cache, and no final was asked for

    def test_offline(self):
        self.table("good")
        r = self.run_fetch("--offline", expect=1)
        self.assertIn("--offline", r.stderr)
        self.assertEqual(self.server.seen, [])
        self.run_fetch()
        self.server.seen.clear()
        self.assert_fetched(self.run_fetch("--offline"))
        self.assertEqual(self.server.seen, [])

    def test_damaged_cache(self):
        self.table("good")
        self.run_fetch()
        self.place().write_bytes(IONEX[:-100])
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertIn("SHA-256 differs", r.stderr)
        self.place().write_bytes(IONEX[:-100])
        self.run_fetch("--offline", expect=1)

    def test_file_put_into_the_cache_by_hand(self):
        self.table("missing")
        self.place().parent.mkdir(parents=True)
        self.place().write_bytes(IONEX)
        self.assert_fetched(self.run_fetch())
        self.assertEqual(self.server.seen, [])

    def test_many_days_in_parallel(self):
        self.server.files = {"weekly.erp.gz": gzip.compress(made.ERP_TAI.encode(), mtime=0)}
        self.table("good", names=["name erp COD final - - weekly.erp.gz start=week"])
        r = subprocess.run([ORRERY, "fetch", "2024-09-29", "--to", "2024-09-30", "--products", "erp", "--cache", str(self.cache),
                            "--archives", str(pathlib.Path(self.folder.name) / "archives.txt"), "--parallel", "8"],
                           capture_output=True, text=True, timeout=60)
        self.assertEqual(r.returncode, 0, r.stderr)
        self.assertEqual(len(set(r.stdout.split())), 1)  # one weekly file for both days
        self.assertEqual(len(self.asked("good")), 1)     # fetched once

    def test_interrupt_leaves_a_part_that_is_resumed(self):
        self.table("slow")
        p = subprocess.Popen(self.command(stall="30"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        try:
            for _ in range(200):
                if any(f.stat().st_size > 0 for f in self.cache.rglob("*.part")):
                    break
                time.sleep(0.05)
            p.send_signal(signal.SIGINT)
            p.communicate(timeout=20)
        finally:
            p.kill()
            p.wait()
        self.assertIn(p.returncode, (1, -signal.SIGINT))
        self.assertFalse(self.place().exists())
        self.assertEqual([f.stat().st_size for f in self.cache.rglob("*.part")], [5000])
        r = self.run_fetch()
        self.assert_fetched(r)
        self.assertEqual(self.asked("slow")[1][2], "bytes=5000-")

    def test_usage(self):
        self.table("good")
        for args in (["--products", "sp4"], ["--products", "obs"], ["--products", "sp3:BOR1"], ["--to", "2024-02-01"]):
            self.run_fetch(*args, expect=2)
        r = subprocess.run([ORRERY, "fetch", "--print-archives"], capture_output=True, text=True, timeout=20)
        self.assertIn("mirror CDDIS", r.stdout)
        printed = pathlib.Path(self.folder.name) / "printed.txt"
        printed.write_text(r.stdout)
        r = subprocess.run([ORRERY, "fetch", DAY, "--archives", str(printed), "--offline", "--cache", str(self.cache)],
                           capture_output=True, text=True, timeout=20)
        self.assertEqual(r.returncode, 1)  # legible, and nothing is in the cache

    def test_table_with_an_error(self):
        self.table("good", extra="mirror x\n")
        r = self.run_fetch(expect=1)
        self.assertIn("archives.txt:3", r.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=1)
