"""The server and the command line as the reliability tests start, ask and kill them."""

import http.client
import json
import math
import os
import random
import signal
import subprocess
import threading
import time
import urllib.parse

KEY = "a-key-for-tests-0123456789"


def off_model(number):
    """A small model as OFF text, another one for each number: a bent tube with a lid at each end."""
    shape = random.Random(f"model {number}")
    rings, sides = 12, 8
    bend, swell = shape.uniform(-1.5, 1.5), shape.uniform(0.1, 0.6)
    width, phase = shape.uniform(0.2, 0.5), shape.uniform(0.0, 6.0)
    points = []
    for ring in range(rings):
        t = ring / (rings - 1)
        radius = width * (1.0 + swell * math.sin(5.0 * t + phase))
        for side in range(sides):
            angle = 2.0 * math.pi * side / sides
            points.append((4.0 * t, radius * math.cos(angle) + bend * t * t,
                           radius * math.sin(angle)))
    faces = []
    for ring in range(rings - 1):
        for side in range(sides):
            a, b = ring * sides + side, ring * sides + (side + 1) % sides
            faces.append((a, b, b + sides, a + sides))
    faces.append(tuple(reversed(range(sides))))
    faces.append(tuple(range((rings - 1) * sides, rings * sides)))
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [f"{x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    lines += [" ".join(map(str, (len(face), *face))) for face in faces]
    return "\n".join(lines) + f"\n# {number}\n"


class Answer:
    """An HTTP answer; status 0 when the connection ended without one."""

    def __init__(self, status, body):
        self.status = status
        self.body = body

    def json(self):
        return json.loads(self.body)


class Server:
    """An ossuary-server with an administrator's key on a port of its own."""

    def __init__(self, program, index, log, options=()):
        key_file = f"{index}.key"
        with open(key_file, "w", encoding="ascii") as key:
            key.write(KEY + "\n")
        self.log = open(log, "ab")
        self.process = subprocess.Popen(
            [program, "--index", index, "--port", "0", "--admin-key-file", key_file,
             "--web", web_folder(index), *options],
            stdout=subprocess.PIPE, stderr=self.log)
        ready = self.process.stdout.readline().decode()
        if not ready.startswith("listening on "):
            raise RuntimeError(f"the server did not start, see {log}")
        self.port = int(ready.rsplit(":", 1)[1])

    def ask(self, method, path, body=None, timeout=120):
        """One request on a connection of its own."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.request(method, path, body,
                               {"Authorization": f"Bearer {KEY}"} if method != "GET" else {})
            answer = connection.getresponse()
            return Answer(answer.status, answer.read())
        except (OSError, http.client.HTTPException):
            return Answer(0, b"")
        finally:
            connection.close()

    def upload(self, name, off):
        return self.ask("POST", "/v1/models?name=" + urllib.parse.quote(name), off)

    def models(self):
        """All models by name, or None when a page cannot be had."""
        found, cursor = {}, ""
        while True:
            answer = self.ask("GET", "/v1/models?limit=500" + cursor)
            if answer.status != 200:
                return None
            page = answer.json()
            for model in page["models"]:
                found[model["name"]] = model["id"]
            if page["next_cursor"] is None:
                return found
            cursor = "&cursor=" + page["next_cursor"]

    def end(self, how=signal.SIGTERM):
        """Sends the signal and waits; the exit status."""
        self.process.send_signal(how)
        status = self.process.wait()
        self.process.stdout.close()
        self.log.close()
        return status


def web_folder(index):
    """A gallery of one page, so that the server does not look for a built one."""
    folder = f"{index}.web"
    os.makedirs(folder, exist_ok=True)
    with open(f"{folder}/index.html", "w", encoding="ascii") as page:
        page.write("<!doctype html><title>gallery</title>")
    return folder


class CommandLine:
    """The ossuary program on one index."""

    def __init__(self, program, index):
        self.program = program
        self.index = index

    def start(self, *arguments):
        return subprocess.Popen([self.program, *arguments, "--index", self.index],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, *arguments):
        return subprocess.run([self.program, *arguments, "--index", self.index],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)

    def models(self):
        """All models by name."""
        listed = self.run("models", "--json")
        if listed.returncode != 0:
            return None
        return {model["name"]: model["id"] for model in json.loads(listed.stdout)["models"]}


class Faults:
    """What went wrong; the run goes on and fails at its end."""

    def __init__(self):
        self.lock = threading.Lock()
        self.texts = []

    def add(self, text):
        with self.lock:
            self.texts.append(text)
        print(f"FAULT: {text}", flush=True)


def write_model(folder, name, number):
    """A model file that is whole from the moment it is there."""
    os.makedirs(folder, exist_ok=True)
    with open(f"{folder}/{name}.part", "w", encoding="ascii") as file:
        file.write(off_model(number))
    os.rename(f"{folder}/{name}.part", f"{folder}/{name}.off")


def wait_until(condition, seconds, interval=0.05):
    """Whether the condition came true in time."""
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(interval)
    return True
