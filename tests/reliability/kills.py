#!/usr/bin/env python3
"""Kills the server and the indexer (SIGKILL) at random moments while they write one index. Every
upload that was accepted (202) must be in the collection in the end, or be recorded as failed with its
code; job numbers must not be given twice; `verify` must find nothing after any of the kills.

Exit status 0 when all of that held, else 1."""

import argparse
import os
import random
import shutil
import signal
import sys
import tempfile
import threading
import time

from by_turns import prepare
from programs import CommandLine, Faults, Server, off_model, wait_until, write_model


class Run:
    """One index through all the kills."""

    def __init__(self, arguments, folder):
        self.arguments = arguments
        self.folder = folder
        self.index = f"{folder}/models.ossuary"
        self.library = f"{folder}/library"
        self.command_line = CommandLine(arguments.ossuary, self.index)
        self.random = random.Random(arguments.seed)
        self.faults = Faults()
        self.number = 0
        self.jobs = set()      # all numbers ever given
        self.waiting = {}      # accepted and not known to be finished: job → name
        self.done = {}         # name → model
        self.failed = {}       # name → code
        self.files = []
        self.kills = {"server": 0, "indexer": 0, "both": 0}

    def upload_until(self, server, stop):
        while not stop.is_set():
            self.number += 1
            name = f"up{self.number}"
            answer = server.upload(name, off_model(self.arguments.seed * 1_000_000 + self.number))
            if answer.status == 202:
                job = answer.json()["job"]
                if job in self.jobs:
                    self.faults.add(f"{job} was given twice")
                self.jobs.add(job)
                self.waiting[job] = name
            elif answer.status not in (0, 503):
                self.faults.add(f"upload: status {answer.status}: {answer.body[:300]!r}")
            # Few enough to be worked off between the kills.
            stop.wait(0.02 if len(self.waiting) < 10 else 0.5)

    def follow(self, server):
        """Learns what became of the jobs; every one that was accepted must be known."""
        for job, name in list(self.waiting.items()):
            answer = server.ask("GET", job)
            if answer.status in (0, 503):
                return
            if answer.status != 200:
                self.faults.add(f"{job} ({name}) was accepted and is lost: {answer.status}")
                del self.waiting[job]
                continue
            state = answer.json()
            if state["state"] == "done":
                self.done[name] = state["model"]
                del self.waiting[job]
            elif state["state"] == "failed":
                self.failed[name] = state["error"]["code"]
                del self.waiting[job]
                if not self.failed[name]:
                    self.faults.add(f"{job} ({name}) failed without a code")

    def start_server(self):
        return Server(self.arguments.server, self.index, f"{self.folder}/server.log")

    def start_indexer(self):
        for _ in range(self.random.randint(1, 3)):
            name = f"file{len(self.files)}"
            write_model(self.library, name, name)
            self.files.append(name)
        return self.command_line.start("index", self.library)

    def one_kill(self):
        victim = self.random.choice(("server", "server", "indexer", "both"))
        self.kills[victim] += 1
        server = self.start_server()
        self.follow(server)
        stop = threading.Event()
        uploader = threading.Thread(target=self.upload_until, args=(server, stop))
        uploader.start()
        indexer = self.start_indexer() if victim != "server" or self.random.random() < 0.5 else None
        time.sleep(self.random.uniform(0.0, self.arguments.longest))
        if victim in ("indexer", "both"):
            indexer.send_signal(signal.SIGKILL)
        if victim in ("server", "both"):
            server.end(signal.SIGKILL)
        stop.set()
        uploader.join()
        if victim == "indexer":
            self.follow(server)
            if server.end() != 0:
                self.faults.add("the server did not end well")
        if indexer is not None:
            indexer.communicate()
            if victim == "server" and indexer.returncode != 0:
                self.faults.add(f"index ended with status {indexer.returncode}")
        self.verify()

    def verify(self):
        verified = self.command_line.run("verify")
        if verified.returncode != 0:
            self.faults.add(f"verify after {sum(self.kills.values())} kills: "
                            f"{(verified.stdout + verified.stderr).decode()[-2000:]}")

    def finish(self):
        """Lets all that waits be done, and holds what is there against what was accepted."""
        server = self.start_server()

        def drained():
            self.follow(server)
            return not self.waiting

        if not wait_until(drained, 300):
            self.faults.add(f"not finished: {self.waiting}")
        ended = self.command_line.run("index", self.library)
        if ended.returncode != 0:
            self.faults.add(f"index: {ended.stderr.decode()[-500:]}")
        found = server.models() or {}
        if server.end() != 0:
            self.faults.add("the server did not end well")
        listed = self.command_line.models() or {}
        for name, model in self.done.items():
            if found.get(name) != model or listed.get(name) != model:
                self.faults.add(f"{name} was done as model {model} and is lost")
        for name in self.files:
            if name not in found or name not in listed:
                self.faults.add(f"{name} was indexed and is lost")
        self.verify()

    def run(self):
        base = prepare(self.command_line, self.library)
        os.makedirs(self.library)
        for _ in range(self.arguments.kills):
            self.one_kill()
        self.finish()
        accepted = len(self.done) + len(self.failed) + len(self.waiting)
        codes = ", ".join(sorted(set(self.failed.values()))) or "none"
        good = not self.faults.texts
        print(f"{sum(self.kills.values())} kills {self.kills}: {accepted} uploads accepted, "
              f"{len(self.done)} done, {len(self.failed)} failed (codes: {codes}), "
              f"{len(base) + len(self.files)} files indexed, {len(self.faults.texts)} faults: "
              f"{'passed' if good else 'FAILED, see ' + self.folder}")
        return good


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--server", default="build/release/bin/ossuary-server")
    parser.add_argument("--ossuary", default="build/release/bin/ossuary")
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--longest", type=float, default=1.5, help="seconds before a kill, at most")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    folder = tempfile.mkdtemp(prefix="kills.")
    good = Run(arguments, folder).run()
    if good:
        shutil.rmtree(folder)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
