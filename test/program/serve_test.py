"""`taut serve` from outside: who is answered, which files, jobs that go on without a page, and attacks.

TAUT_PROGRAM is the program, TAUT_SOURCE_DIR the source tree with its examples.
"""
import concurrent.futures
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import tempfile
import unittest

from decks import MAST
from served import PROGRAM, Served, small_page

FEWER = "TAUT_FEWER" in os.environ
EXAMPLES = pathlib.Path(os.environ["TAUT_SOURCE_DIR"]) / "examples"
HEADERS = ("Content-Security-Policy", "X-Content-Type-Options", "X-Frame-Options", "Referrer-Policy", "Cache-Control")

# runs for hours when nobody stops it
ENDLESS = """taut: 1
title: A load that goes up and down
machine:
  signals:
    hoist_speed: {sine: {amplitude: 0.2 m/s, period: 2 s}}
  points: {lead: [0 m, 0 m, 20 m]}
  ropes:
    hoist: {mass: 0 kg/m, stiffness: 10 MN, breaking_force: 150 kN, damping_ratio: 0.03}
  bodies:
    load: {mass: 2 t, at: [0 m, 0 m, 2 m], free: [x, z]}
  drums:
    winch: {at: [0.2 m, 0 m, 20 m], core_diameter: 400 mm, drive: {speed: hoist_speed}}
  reevings:
    - {rope: hoist, path: [{drum: winch, side: left}, {anchor: load}], length: 18 m}
  observe: [load.z, hoist.T_max]
analyses:
  - transient: {duration: 20000 s, output_step: 200 ms, tolerance: 1e-10}
"""


def started(*args):
    return subprocess.run([PROGRAM, "serve", *args], capture_output=True, text=True, check=False)


class ServeCase(unittest.TestCase):
    def setUp(self):
        self.s = Served()

    def tearDown(self):
        code, said = self.s.end()
        self.assertEqual(code, 0, said)
        for word in ("ERROR", "runtime error", "internal error"):
            self.assertNotIn(word, said)


class Access(ServeCase):
    def test_without_the_token_nothing_is_answered(self):
        job = self.s.start_job(MAST)
        paths = ["/", "/page.js", "/style.css", "/nothing", "/api/hello", "/api/schema", "/api/files", "/api/file?name=a.yaml",
                 "/api/jobs", f"/api/jobs/{job}", f"/api/jobs/{job}/events", f"/api/jobs/{job}/report"]
        wrong = self.s.token[:-1] + ("0" if self.s.token[-1] != "0" else "1")
        for path in paths:
            mark = "&" if "?" in path else "?"
            for method in ("GET", "POST", "PUT", "DELETE", "OPTIONS", "HEAD", "PATCH"):
                self.assertEqual(self.s.status(method, path, token=False), 403, f"{method} {path}")
                self.assertEqual(self.s.status(method, f"{path}{mark}token={wrong}", token=False), 403)
                self.assertEqual(self.s.status(method, path, token=False, headers={"X-Taut-Token": wrong}), 403)
        self.assertEqual(self.s.status("GET", f"/api/hello?token={self.s.token}", token=False), 200)
        self.assertEqual(self.s.status("GET", "/api/hello"), 200)
        self.assertGreaterEqual(len(self.s.token), 32)

    def test_other_hosts_and_origins_are_refused(self):
        for host in ("evil.example", f"evil.example:{self.s.port}", "127.0.0.1", f"127.0.0.1:{self.s.port + 1}", "",
                     f"localhost.evil.example:{self.s.port}"):
            self.assertEqual(self.s.status("GET", "/api/hello", headers={"Host": host}), 403, host)
        for origin in ("http://evil.example", "null", f"https://{self.s.host}", f"http://localhost:{self.s.port}"):
            self.assertEqual(self.s.status("POST", "/api/jobs", {"text": MAST}, headers={"Origin": origin}), 403, origin)
        self.assertEqual(self.s.json("GET", "/api/jobs")["jobs"], [])
        own = {"Origin": f"http://{self.s.host}"}
        self.assertEqual(self.s.status("POST", "/api/jobs", {"text": MAST}, headers=own), 201)
        self.assertEqual(self.s.status("GET", "/api/hello", headers={"Host": f"localhost:{self.s.port}"}), 200)

    def test_every_answer_carries_the_policy_and_none_a_permission(self):
        for method, path, token in (("GET", "/", True), ("GET", "/", False), ("GET", "/nothing", True), ("OPTIONS", "/", True),
                                    ("POST", "/api/jobs", True), ("GET", "/page.js", True)):
            _, headers, _ = self.s.ask(method, path, token=token, headers={"Origin": f"http://{self.s.host}"})
            for name in HEADERS:
                self.assertEqual(len(headers.get_all(name, [])), 1, f"{method} {path} {name}")
            self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
            self.assertFalse([h for h in headers if h.lower().startswith("access-control")])
            self.assertNotIn("Set-Cookie", headers)
        refused = self.s.raw(b"nonsense\r\n")
        self.assertIn(b"Content-Security-Policy: default-src 'none'", refused)

    def test_the_page_carries_the_token_to_its_parts(self):
        status, headers, text = self.s.ask("GET", f"/?token={self.s.token}", token=False)
        self.assertEqual((status, headers["Content-Type"]), (200, "text/html; charset=utf-8"))
        self.assertIn("'nonce-n0nce'", headers["Content-Security-Policy"])
        self.assertIn("data-served", text.decode())
        for part in ("page.js", "style.css"):
            self.assertIn(f'"{part}?token={self.s.token}"', text.decode())
        self.assertEqual(self.s.ask("GET", "/page.js")[2], b"'script'")

    @unittest.skipUnless(os.path.exists("/proc/net/tcp"), "there is no list of sockets")
    def test_it_listens_at_the_loopback_device_alone(self):
        listening = []
        for table in ("/proc/net/tcp", "/proc/net/tcp6"):
            rows = pathlib.Path(table).read_text().splitlines()[1:] if os.path.exists(table) else []
            fields = [row.split() for row in rows]
            listening += [f[1].split(":")[0] for f in fields if f[3] == "0A" and int(f[1].split(":")[1], 16) == self.s.port]
        self.assertEqual(listening, ["0100007F"])


class Files(ServeCase):
    def test_the_folder_is_listed_opened_and_saved(self):
        (self.s.decks / "lines").mkdir()
        (self.s.decks / "lines" / "mast.yaml").write_text(MAST)
        (self.s.decks / "notes.txt").write_text("n")
        self.assertEqual(self.s.json("GET", "/api/files"), {"names": ["lines/mast.yaml"], "whole": True})
        self.assertEqual(self.s.ask("GET", "/api/file?name=lines/mast.yaml")[2].decode(), MAST)
        text = MAST + "# \u00e9\u4e2d\n"
        self.assertEqual(self.s.status("PUT", "/api/file?name=lines%2Fnew.yaml", text.encode()), 200)
        self.assertEqual((self.s.decks / "lines" / "new.yaml").read_text("utf-8"), text)
        self.assertEqual(self.s.status("GET", "/api/file?name=notes.txt"), 403)
        self.assertEqual(self.s.status("PUT", "/api/file?name=run.sh", b"x"), 403)
        self.assertEqual(self.s.status("GET", "/api/file?name=nowhere.yaml"), 404)

    def test_no_path_leads_out_of_the_folder(self):
        (self.s.top / "secret.yaml").write_text("the secret")
        (self.s.decks / "sub").mkdir()
        (self.s.decks / "link.yaml").symlink_to(self.s.top / "secret.yaml")
        (self.s.decks / "up").symlink_to(self.s.top)
        (self.s.decks / "dangling.yaml").symlink_to(self.s.top / "new.yaml")
        for name in ("../secret.yaml", "..%2Fsecret.yaml", "sub/../../secret.yaml", "/etc/passwd", str(self.s.top / "secret.yaml"),
                     "link.yaml", "up/secret.yaml", "dangling.yaml", "%2e%2e/secret.yaml", "....//../../secret.yaml"):
            for method, body in (("GET", None), ("PUT", b"x")):
                status, _, text = self.s.ask(method, f"/api/file?name={name}", body)
                self.assertEqual(status, 403, f"{method} {name}")
                self.assertNotIn(b"the secret", text)
        for path in ("/../secret.yaml", "/..%2f..%2fsecret.yaml", "//etc/passwd", "/page/../../secret.yaml"):
            self.assertNotIn(b"the secret", self.s.raw(f"GET {path}?token={self.s.token} HTTP/1.1\r\nHost: {self.s.host}\r\n\r\n".encode()))
        self.assertEqual((self.s.top / "secret.yaml").read_text(), "the secret")
        self.assertFalse((self.s.top / "new.yaml").exists())
        self.assertEqual(self.s.json("GET", "/api/files")["names"], [])

    def test_decks_reach_files_of_the_folder_and_no_other(self):
        (self.s.top / "secret.part.yaml").write_text("skyline: 4711\n")
        (self.s.decks / "mast.part.yaml").write_text(MAST)
        (self.s.decks / "link.part.yaml").symlink_to(self.s.top / "secret.part.yaml")
        (self.s.decks / "lines").mkdir()
        for include, name in (("mast.part.yaml", "a.yaml"), ("../mast.part.yaml", "lines/a.yaml")):
            page = self.answer(f"include: {include}\n", name)
            self.assertEqual(page["status"], "ok", page["errors"])
        for include in ("../secret.part.yaml", str(self.s.top / "secret.part.yaml"), "link.part.yaml", "/etc/passwd"):
            page = self.answer(f"include: {include}\n", "a.yaml")
            self.assertEqual(page["status"], "bad_deck", include)
            self.assertIn("outside the folder" if "link" not in include else "out of the folder", page["errors"][0]["message"])
            self.assertNotIn("4711", json.dumps(page))
        page = self.answer("include: mast.part.yaml\n", "../a.yaml")
        self.assertEqual(page["status"], "bad_deck")
        page = self.answer("include: x/mast.part.yaml\n", "a.yaml", files={"x/mast.part.yaml": MAST})
        self.assertEqual(page["status"], "ok", "files of the page come before those of the folder")
        with tempfile.TemporaryDirectory() as elsewhere:
            (pathlib.Path(elsewhere) / "ground.csv").write_text("x,z\n0,0\n4711,1\n")
            deck = (EXAMPLES / "machines" / "endless_haul.yaml").read_text()
            terrain = deck[deck.index("  terrain: {"):]
            deck = deck.replace(terrain[:terrain.index("}") + 1], f"  terrain: {{file: {elsewhere}/ground.csv}}")
            page = self.answer(deck, "a.yaml")
            self.assertIn("outside the folder", page["errors"][0]["message"])
            self.assertNotIn("4711", json.dumps(page["errors"]))

    def answer(self, text, name, **more):
        job = self.s.start_job(text, name, **more)
        self.s.ended(job)
        return self.s.json("GET", f"/api/jobs/{job}")["page"]

    def test_what_is_too_large_is_refused(self):
        self.assertEqual(self.s.status("PUT", "/api/file?name=a.yaml", b" " * (16 * 1024 * 1024 + 1)), 413)
        self.assertFalse((self.s.decks / "a.yaml").exists())
        head = f"POST /api/jobs HTTP/1.1\r\nHost: {self.s.host}\r\nX-Taut-Token: {self.s.token}\r\nContent-Type: application/json\r\n"
        self.assertIn(b" 413 ", self.s.raw(f"{head}Content-Length: 99999999999\r\n\r\n".encode()))
        self.assertIn(b" 411 ", self.s.raw(f"{head}Transfer-Encoding: chunked\r\n\r\n2\r\n{{}}\r\n0\r\n\r\n".encode()))
        self.assertIn(b" 411 ", self.s.raw(f"{head}\r\n{{}}".encode()))
        self.assertIn(b" 415 ", self.s.raw(f"{head}Content-Encoding: gzip\r\nContent-Length: 2\r\n\r\n{{}}".encode()))
        self.assertEqual(self.s.status("POST", "/api/jobs", b"{}", headers={"Content-Type": "multipart/form-data; boundary=x"}), 415)


class Work(ServeCase):
    def test_fifty_jobs_at_once_give_what_the_program_gives(self):
        names = ("mast_section", "friction_drive", "machines/running_skyline", "motion/tackle_hoist", "motion/brake_stop")
        decks = {name: (EXAMPLES / f"{name}.yaml").read_text() for name in names[:2 if FEWER else None]}
        wanted = {name: self.program(text) for name, text in decks.items()}
        chosen = [list(decks)[i % len(decks)] for i in range(50)]

        def solved(name):
            job = self.s.start_job(decks[name], f"{name}.yaml")
            self.assertEqual(self.s.ended(job)[1]["state"], "done")
            self.assertEqual(self.s.json("GET", f"/api/jobs/{job}")["page"]["status"], "ok")
            return self.s.json("GET", f"/api/jobs/{job}/json")

        with concurrent.futures.ThreadPoolExecutor(16) as pool:
            got = list(pool.map(solved, chosen))
        for name, result in zip(chosen, got, strict=True):
            for part in ("values", "checks", "tables", "steps", "verdict", "warnings"):
                self.assertEqual(result[part], wanted[name][part], f"{name} {part}")
        self.assertEqual(len(self.s.json("GET", "/api/jobs")["jobs"]), 50)

    @staticmethod
    def program(text):
        return json.loads(subprocess.run([PROGRAM, "run", "-", "--json"], input=text, capture_output=True, text=True, check=False).stdout)

    def test_stop_gives_what_is_done(self):
        job = self.s.start_job(ENDLESS)
        events = self.s.events(job)
        self.assertGreater(next(e for _, e in events if e["progress"]["done"] > 0)["progress"]["done"], 0)
        self.assertEqual(self.s.status("GET", f"/api/jobs/{job}"), 202)
        self.assertEqual(self.s.status("GET", f"/api/jobs/{job}/report"), 404)
        self.assertEqual(self.s.status("POST", f"/api/jobs/{job}/stop"), 202)
        kind, last = list(events)[-1]
        self.assertEqual((kind, last["state"]), ("done", "stopped"))
        page = self.s.json("GET", f"/api/jobs/{job}")["page"]
        self.assertTrue(page["interrupted"])
        self.assertIn("interrupted at t =", page["message"])
        self.assertGreater(len(page["scenes"][0]["t"]), 1)
        self.assertIn("interrupted at t =", self.s.json("GET", f"/api/jobs/{job}/json")["message"])
        self.assertIn(b"</html>", self.s.ask("GET", f"/api/jobs/{job}/report")[2])

    def test_a_job_outlives_its_reader(self):
        job = self.s.start_job(ENDLESS, "long.yaml", files={"x.csv": "1"})
        first = self.s.events(job)
        before = next(e for _, e in first if e["progress"]["done"] > 0)["progress"]["done"]
        first.close()  # the tab is closed
        entry = self.s.json("GET", "/api/jobs")["jobs"][-1]
        self.assertEqual((entry["id"], entry["name"], entry["state"]), (job, "long.yaml", "running"))
        self.assertEqual(self.s.json("GET", f"/api/jobs/{job}/deck"),
                         {"text": ENDLESS, "name": "long.yaml", "files": {"x.csv": "1"}, "set": []})
        again = self.s.events(job)
        self.assertGreater(next(e for _, e in again if e["progress"]["done"] > before)["progress"]["done"], before)
        self.s.json("POST", f"/api/jobs/{job}/stop")
        self.assertEqual(list(again)[-1][1]["state"], "stopped")
        self.assertTrue(self.s.json("GET", f"/api/jobs/{job}")["page"]["interrupted"], "and so does its result")
        self.s.json("DELETE", f"/api/jobs/{job}")
        self.assertEqual(self.s.status("GET", f"/api/jobs/{job}"), 404)

    def test_readers_of_events_leave_room_for_others(self):
        job = self.s.start_job(ENDLESS)
        readers, refused = [], 0
        for _ in range(60):
            reader = self.s.events(job)
            try:
                next(reader)
                readers.append(reader)
            except AssertionError as e:
                self.assertIn("503", str(e))
                refused += 1
        self.assertGreater(len(readers), 10)
        self.assertGreater(refused, 10)
        self.assertEqual(self.s.status("GET", "/api/hello"), 200)
        self.s.json("DELETE", f"/api/jobs/{job}")
        for reader in readers:
            list(reader)  # the job is gone, and so they end
        job = self.s.start_job(MAST)
        self.assertEqual(self.s.ended(job)[0], "done", "there is room again")

    def test_ctrl_c_ends_it_at_work_and_read(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            other = Served()
            job = other.start_job(ENDLESS)
            reader = other.events(job)
            next(reader)
            other.start_job(ENDLESS)
            code, said = other.end(how)
            self.assertEqual(code, 0, said)


class Attacks(ServeCase):
    def test_a_thousand_malformed_requests(self):
        chance = random.Random(20261125)
        answered = 0
        for _ in range(200 if FEWER else 1000):
            got = self.s.raw(self.malformed(chance), hang_up=True)
            if got:
                answered += 1
                self.assertTrue(got.startswith(b"HTTP/1.1 "), got[:60])
                self.assertNotIn(b" 500 ", got[:20])
        self.assertGreater(answered, 50)
        self.assertIsNone(self.s.program.poll(), "it still runs")
        job = self.s.start_job(MAST)
        self.assertEqual(self.s.ended(job)[1]["state"], "done")

    def malformed(self, chance):
        """A request with a mistake of one of many kinds, half of them with the token."""
        noise = lambda n: bytes(chance.randrange(256) for _ in range(n))
        token = f"X-Taut-Token: {self.s.token}\r\n" if chance.random() < 0.5 else ""
        head = f"Host: {self.s.host}\r\n{token}".encode()
        kind = "Content-Type: application/json\r\n".encode()
        body = chance.choice([b"{", b"[" * 5000, b"null", b'{"text": 1}', b'{"text": "\xff"}', noise(200), b'{"text": "' + b"[" * 9000 + b'"}'])
        length = chance.choice([len(body), len(body) + 5, 0, -1, 10**30, "x", "", " ", f"{len(body)}, {len(body)}", "0x10"])
        size = f"Content-Length: {length}\r\n".encode()
        path = chance.choice(["/", "/api/jobs", "/api/jobs/1/stop", "/api/jobs/" + "9" * 300, "/api/file?name=" + "../" * 50, "/" + "a" * 9000,
                              "/%", "/%zz%00", "/api/file?name=%00", "/?" + "&" * 5000, "//", "/api/" + "/" * 2000, "*", "", "http://x/"]).encode()
        method = chance.choice([b"GET", b"POST", b"PUT", b"DELETE", b"PRI", b"CONNECT", b"TRACE", b"get", b"", b"\0", b"G" * 9000])
        version = chance.choice([b"HTTP/1.1", b"HTTP/1.0", b"HTTP/9.9", b"HTTP", b"", noise(5)])
        line = method + b" " + path + b" " + version + b"\r\n"
        extra = chance.choice([b"", b"Range: bytes=" + b"0-0," * 1900 + b"0-0\r\n", b"Range: bytes=9-1\r\n", b"Expect: 100-continue\r\n",
                               b"X: " + b"y" * 9000 + b"\r\n", b"".join(b"A%d: b\r\n" % i for i in range(3000)), b"no colon\r\n",
                               b": empty\r\n", b"Host: other\r\n", b"A: b\r\n c: folded\r\n", b"A: \0\r\n", b"Connection: close, keep-alive\r\n",
                               b"Transfer-Encoding: chunked\r\n", b"Content-Encoding: br\r\n", b"Accept-Encoding: gzip, br\r\n"])
        whole = line + head + kind + size + extra + b"\r\n" + body
        how = chance.randrange(6)
        if how == 0:
            return noise(chance.randrange(1, 3000))
        if how == 1:
            return whole[:chance.randrange(len(whole))]
        if how == 2:
            spoiled = bytearray(whole)
            for _ in range(chance.randrange(1, 30)):
                spoiled[chance.randrange(len(spoiled))] = chance.randrange(256)
            return bytes(spoiled)
        if how == 3:
            return whole.replace(b"\r\n", chance.choice([b"\n", b"\r", b"\r\n\r\n", b""]), chance.randrange(1, 5))
        return whole

    def test_connections_that_say_nothing_keep_nobody_out(self):
        idle = [socket.create_connection(("127.0.0.1", self.s.port)) for _ in range(60)]
        self.assertEqual(self.s.status("GET", "/api/hello"), 200)
        for link in idle:
            link.close()


class Start(unittest.TestCase):
    def test_what_cannot_be_served(self):
        with tempfile.TemporaryDirectory() as folder:
            page = str(small_page(folder))
            done = started(folder + "/nowhere", "--page", page)
            self.assertEqual(done.returncode, 5, done.stderr)
            self.assertIn("nowhere", done.stderr)
            done = started(folder, "--page", folder + "/nopage")
            self.assertEqual(done.returncode, 5)
            self.assertIn("./dev web", done.stderr)
            with socket.create_server(("127.0.0.1", 0)) as taken:
                port = str(taken.getsockname()[1])
                done = started(folder, "--page", page, "--port", port)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"port {port} of 127.0.0.1 is taken", done.stderr)
            for bad in ("70000", "-1", "x"):
                self.assertEqual(started(folder, "--page", page, "--port", bad).returncode, 2)

    def test_two_servers_do_not_share_a_port(self):
        first = Served()
        try:
            done = started(str(first.decks), "--page", str(first.top / "page"), "--port", str(first.port))
            self.assertEqual(done.returncode, 2, done.stderr)
        finally:
            self.assertEqual(first.end()[0], 0)


if __name__ == "__main__":
    unittest.main()
