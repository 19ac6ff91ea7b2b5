#!/usr/bin/env python3
"""The server and the command line write one index by turns under load: uploads, deletions, searches,
evaluations and statistics in the server; indexing, pruning and listing beside it. Nothing that was
acknowledged may be lost, both must see everything, and `verify` must find nothing.

Exit status 0 when all of that held, else 1."""

import argparse
import os
import random
import shutil
import sys
import tempfile
import threading
import time

from programs import CommandLine, Faults, Server, off_model, wait_until, write_model

# Uploads that are kept; more are deleted again, so that searches stay quick.
KEPT = 60
FILES = 60


class Load:
    """What was acknowledged, and by which name a model must be there."""

    def __init__(self, server, command_line, library, seed):
        self.server = server
        self.command_line = command_line
        self.library = library
        self.seed = seed
        self.faults = Faults()
        self.lock = threading.Lock()
        self.stop = threading.Event()
        self.numbers = iter(range(1, 1 << 30))
        self.jobs = {}        # accepted uploads that are not finished: job → name
        self.uploads = {}     # acknowledged and not deleted: name → id
        self.files = {}       # indexed, and there: name → None
        self.going = set()    # names on their way out
        self.counts = dict.fromkeys(
            ("accepted", "deleted", "indexed", "pruned", "searches", "evaluations", "runs",
             "comparisons", "refused"), 0)

    def count(self, what, number=1):
        with self.lock:
            self.counts[what] += number

    def next_number(self):
        with self.lock:
            return self.seed * 1_000_000 + next(self.numbers)

    def judge(self, answer, what, good):
        """Counts a refusal (503); anything else that is not good is a fault."""
        if answer.status == good:
            return True
        if answer.status == 503:
            self.count("refused")
            self.stop.wait(0.2)
        else:
            self.faults.add(f"{what}: status {answer.status}: {answer.body[:300]!r}")
        return False

    def upload(self):
        number = self.next_number()
        name = f"up{number}"
        answer = self.server.upload(name, off_model(number))
        if self.judge(answer, "upload", 202):
            with self.lock:
                self.jobs[answer.json()["job"]] = name
            self.count("accepted")
        self.follow()

    def follow(self):
        with self.lock:
            waiting = list(self.jobs.items())
        for job, name in waiting:
            answer = self.server.ask("GET", job)
            if not self.judge(answer, job, 200):
                continue
            state = answer.json()
            if state["state"] == "failed":
                self.faults.add(f"{job} ({name}) failed: {state['error']}")
            if state["state"] in ("done", "failed"):
                with self.lock:
                    if self.jobs.pop(job, None) and state["state"] == "done":
                        self.uploads[name] = state["model"]

    def delete(self):
        with self.lock:
            candidates = [name for name in self.uploads if name not in self.going]
            if len(candidates) < KEPT:
                candidates = []
            else:
                self.going.add(candidates[0])
        if not candidates:
            self.stop.wait(0.2)
            return
        name = candidates[0]
        answer = self.server.ask("DELETE", f"/v1/models/{self.uploads[name]}")
        deleted = self.judge(answer, "delete", 204)
        with self.lock:
            if deleted:
                self.counts["deleted"] += 1
                del self.uploads[name]
            # What was refused may have been done all the same: it is still on its way out.

    def search(self):
        answer = self.server.ask("POST", "/v1/search?limit=5", off_model(self.next_number()))
        if self.judge(answer, "search", 200):
            self.count("searches")

    def evaluate(self):
        for ranker in ("hybrid", "skeleton", "chain-code"):
            answer = self.server.ask("GET", f"/v1/evaluations/{ranker}")
            if self.judge(answer, "evaluation", 200):
                self.count("evaluations")
            self.stop.wait(0.5)

    def index_files(self):
        """New files, sometimes without some of the old ones."""
        choice = random.Random(self.next_number())
        new = [f"file{self.next_number()}" for _ in range(choice.randint(1, 4))]
        for name in new:
            write_model(self.library, name, name)
        arguments = ["index", self.library]
        gone = []
        with self.lock:
            if len(self.files) > FILES:
                gone = list(self.files)[: len(self.files) - FILES]
                self.going.update(gone)
        for name in gone:
            os.remove(f"{self.library}/{name}.off")
        if gone:
            arguments.append("--prune")
        ended = self.command_line.run(*arguments)
        if ended.returncode != 0:
            self.faults.add(f"index: status {ended.returncode}: {ended.stderr[-300:]!r}")
            return
        with self.lock:
            self.files.update(dict.fromkeys(new))
            for name in gone:
                self.files.pop(name)
            self.counts["runs"] += 1
            self.counts["indexed"] += len(new)
            self.counts["pruned"] += len(gone)
        self.stop.wait(choice.uniform(0.0, 0.5))

    def compare(self):
        """Whether each program sees all that the other and itself have acknowledged."""
        for program in (self.server, self.command_line):
            with self.lock:
                expected = set(self.uploads) | set(self.files)
            found = program.models()
            with self.lock:
                expected -= self.going
            if found is None:
                self.faults.add(f"{type(program).__name__} could not list the models")
                continue
            lost = expected - set(found)
            if lost:
                self.faults.add(f"{type(program).__name__} does not see {sorted(lost)}")
            self.count("comparisons")
        self.stop.wait(1.0)

    def repeat(self, action):
        while not self.stop.is_set():
            try:
                action()
            except Exception as exception:  # a fault of the run, which must end it as failed
                self.faults.add(f"{action.__name__}: {exception!r}")
                self.stop.wait(1.0)

    def run(self, seconds):
        actions = [self.upload, self.upload, self.delete, self.search, self.evaluate,
                   self.index_files, self.compare]
        threads = [threading.Thread(target=self.repeat, args=(action,)) for action in actions]
        for thread in threads:
            thread.start()
        time.sleep(seconds)
        self.stop.set()
        for thread in threads:
            thread.join()

    def drained(self):
        self.follow()
        return not self.jobs


def prepare(command_line, library):
    """Two classes, so that there is something to evaluate, and statistics."""
    names = [f"base{number}" for number in range(8)]
    for name in names:
        write_model(f"{library}-base", name, name)
    with open(f"{library}.cla", "w", encoding="ascii") as classes:
        classes.write("PSB 1\n2 8\n\n")
        for label, part in (("even", names[0::2]), ("odd", names[1::2])):
            classes.write(f"{label} 0 {len(part)}\n" + "\n".join(part) + "\n\n")
    ended = command_line.run("index", f"{library}-base", "--classes", f"{library}.cla",
                             "--resolution", "24")
    if ended.returncode != 0:
        raise RuntimeError(ended.stderr.decode())
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--server", default="build/release/bin/ossuary-server")
    parser.add_argument("--ossuary", default="build/release/bin/ossuary")
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    folder = tempfile.mkdtemp(prefix="by_turns.")
    index, library = f"{folder}/models.ossuary", f"{folder}/library"
    command_line = CommandLine(arguments.ossuary, index)
    base = prepare(command_line, library)
    os.makedirs(library)

    server = Server(arguments.server, index, f"{folder}/server.log")
    load = Load(server, command_line, library, arguments.seed)
    load.run(60.0 * arguments.minutes)
    if not wait_until(load.drained, 300):
        load.faults.add(f"{len(load.jobs)} accepted uploads were not finished in time")
    status = server.end()
    if status != 0:
        load.faults.add(f"the server ended with status {status}")

    expected = set(base) | set(load.uploads) | set(load.files)
    found = set(command_line.models() or ())
    lost = expected - found - load.going
    strange = found - expected - load.going
    verified = command_line.run("verify")
    if verified.returncode != 0:
        load.faults.add(f"verify: {verified.stdout.decode()[-2000:]}")
    for name in sorted(lost):
        load.faults.add(f"{name} was acknowledged and is lost")
    for name in sorted(strange):
        load.faults.add(f"{name} is there and should not be")
    print(", ".join(f"{number} {what}" for what, number in load.counts.items()))
    good = not load.faults.texts
    print(f"{arguments.minutes:g} minutes: {len(lost)} lost, {len(load.faults.texts)} faults, "
          f"verify {'clean' if verified.returncode == 0 else 'NOT CLEAN'}: "
          f"{'passed' if good else 'FAILED, see ' + folder}")
    if good:
        shutil.rmtree(folder)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
