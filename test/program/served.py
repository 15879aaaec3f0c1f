"""A `taut serve` for tests: a folder with decks, a small page, and questions to it."""
import http.client
import json
import os
import pathlib
import signal
import socket
import subprocess
import tempfile

PROGRAM = os.environ["TAUT_PROGRAM"]
PAGE = '<!DOCTYPE html>\n<html lang="en" data-nonce="n0nce">\n<link href="style.css"><script src="page.js"></script></html>\n'


def small_page(folder):
    site = pathlib.Path(folder) / "page"
    site.mkdir()
    for name, text in (("index.html", PAGE), ("page.js", "'script'"), ("style.css", "b {}")):
        (site / name).write_text(text)
    return site


class Served:
    """The program in a scratch folder `top`; it serves `top/decks`."""

    def __init__(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.top = pathlib.Path(self.scratch.name)
        self.decks = self.top / "decks"
        self.decks.mkdir()
        self.program = subprocess.Popen([PROGRAM, "serve", str(self.decks), "--page", str(small_page(self.top))],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.address = self.program.stdout.readline().strip()
        start, self.token = self.address.split("/?token=")
        self.host = start.removeprefix("http://")
        self.port = int(self.host.split(":")[1])

    def ask(self, method, path, body=None, headers=None, token=True):
        """Status, headers and body of an answer."""
        given = {"X-Taut-Token": self.token} if token else {}
        if body is not None:
            given["Content-Type"] = "application/json" if isinstance(body, (dict, list)) else "text/plain"
            body = json.dumps(body).encode() if isinstance(body, (dict, list)) else body
        link = http.client.HTTPConnection("127.0.0.1", self.port)
        try:
            link.request(method, path, body, {**given, **(headers or {})})
            answer = link.getresponse()
            return answer.status, answer.headers, answer.read()
        finally:
            link.close()

    def status(self, *args, **kwargs):
        return self.ask(*args, **kwargs)[0]

    def json(self, method, path, body=None):
        status, _, text = self.ask(method, path, body)
        if status >= 400:
            raise AssertionError(f"{method} {path}: {status} {text[:200]}")
        return json.loads(text)

    def start_job(self, text, name="deck.yaml", **more):
        return self.json("POST", "/api/jobs", {"text": text, "name": name, **more})["id"]

    def events(self, job):
        """The events of a job as they come: (kind, data). A generator; closing it closes the connection."""
        link = http.client.HTTPConnection("127.0.0.1", self.port)
        try:
            link.request("GET", f"/api/jobs/{job}/events?token={self.token}")
            answer = link.getresponse()
            if answer.status != 200:
                raise AssertionError(f"{answer.status} {answer.read()[:200]}")
            kind = None
            for line in answer:
                line = line.decode().strip()
                if line.startswith("event: "):
                    kind = line[7:]
                if line.startswith("data: "):
                    yield kind, json.loads(line[6:])
        finally:
            link.close()

    def ended(self, job):
        """Waits for the end of a job: its last event."""
        *_, last = self.events(job)
        return last

    def raw(self, data, hang_up=False):
        """What comes back for these bytes. `hang_up`: no more will come, and the server need not wait for it; it may
        then keep its answer to itself."""
        got = b""
        with socket.create_connection(("127.0.0.1", self.port)) as link:
            try:
                link.sendall(data)
                if hang_up:
                    link.shutdown(socket.SHUT_WR)
            except OSError:
                pass  # answered and closed before it was read to its end
            try:
                while part := link.recv(65536):
                    got += part
            except ConnectionError:
                pass
        return got

    def end(self, how=signal.SIGINT):
        """Exit code and what it said."""
        if self.program.poll() is None:
            self.program.send_signal(how)
        try:
            _, said = self.program.communicate()
        finally:
            self.scratch.cleanup()
        return self.program.returncode, said
