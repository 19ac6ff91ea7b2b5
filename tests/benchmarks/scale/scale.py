#!/usr/bin/env python3
"""What a large index costs: start, memory, searches, lists, writes (docs/performance.md).

    scale.py --bin build/release/bin --index FILE --query MODEL.off [--searches 100] [--json]

The server is started on the index, as is the command line; the index is written to (models of it
are removed), so give it a copy. Times are those of a client on the same machine, keep-alive.
"""

import argparse
import http.client
import json
import os
import pathlib
import random
import secrets
import subprocess
import tempfile
import threading
import time


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


class Server:
    """A server on an index, and what it tells of itself."""

    def __init__(self, binaries, index):
        self.folder = tempfile.TemporaryDirectory()
        self.key = secrets.token_hex(16)
        key_file = pathlib.Path(self.folder.name) / "key"
        key_file.write_text(self.key + "\n")
        key_file.chmod(0o600)
        self.port = random.Random(os.getpid()).randrange(20000, 50000)
        started = time.perf_counter()
        self.process = subprocess.Popen(
            [binaries / "ossuary-server", "--index", index, "--port", str(self.port),
             "--admin-key-file", key_file],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while True:
            try:
                self.get("/readyz")
                break
            except OSError:
                if self.process.poll() is not None:
                    raise SystemExit("the server did not start") from None
                time.sleep(0.005)
        self.start_seconds = time.perf_counter() - started

    def connect(self):
        return http.client.HTTPConnection("127.0.0.1", self.port, timeout=600)

    def get(self, path):
        return ask(self.connect(), path)

    def memory_mb(self):
        for line in pathlib.Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith("VmRSS"):
                return int(line.split()[1]) / 1024
        return 0

    def processor_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")")[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def stop(self):
        self.process.terminate()
        self.process.wait()


def ask(connection, path, method="GET", key=None):
    headers = {"Authorization": f"Bearer {key}"} if key else {}
    connection.request(method, path, headers=headers)
    answer = connection.getresponse()
    body = answer.read()
    if answer.status >= 300:
        raise SystemExit(f"{method} {path}: {answer.status} {body[:200]}")
    return json.loads(body) if body else None


def times_ms(connection, paths):
    times = []
    for path in paths:
        started = time.perf_counter()
        ask(connection, path)
        times.append(1000 * (time.perf_counter() - started))
    return times


def measure(server, paths):
    connection = server.connect()
    times_ms(connection, paths[:3])
    before = server.processor_seconds()
    times = times_ms(connection, paths)
    return {"p50_ms": percentile(times, 0.5), "p99_ms": percentile(times, 0.99),
            "processor_ms": 1000 * (server.processor_seconds() - before) / len(paths)}


def measure_writes(server, searches, victims):
    """Removes models one by one while searches go on; how long until a search knows."""
    meanwhile, done = [], threading.Event()

    def search_on():
        connection = server.connect()
        while not done.is_set():
            meanwhile.extend(times_ms(connection, [random.choice(searches)]))

    thread = threading.Thread(target=search_on)
    thread.start()
    connection, seen_ms = server.connect(), []
    for victim in victims:
        ask(connection, f"/v1/models/{victim}", "DELETE", server.key)
        started = time.perf_counter()
        total = ask(connection, "/v1/models?limit=1")["total"]
        while ask(connection, "/v1/models?limit=1")["total"] > total:
            pass
        seen_ms.append(1000 * (time.perf_counter() - started))
        time.sleep(0.2)
    done.set()
    thread.join()
    return {"seen_within_ms": max(seen_ms), "searches": len(meanwhile),
            "p50_ms": percentile(meanwhile, 0.5), "p99_ms": percentile(meanwhile, 0.99)}


def measure_command_line(binaries, index, query, runs):
    """Wall clock of `ossuary search` without what describing the query takes."""
    beyond = []
    for _ in range(runs):
        started = time.perf_counter()
        run = subprocess.run([binaries / "ossuary", "search", "--index", index, query, "--json"],
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
        wall = 1000 * (time.perf_counter() - started)
        stages = json.loads(run.stdout)["stages_ms"]
        beyond.append(wall - sum(ms for stage, ms in stages.items()
                                 if stage not in ("rank", "explain")))
    return percentile(beyond, 0.5)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=pathlib.Path, default=pathlib.Path("build/release/bin"))
    parser.add_argument("--index", type=pathlib.Path, required=True)
    parser.add_argument("--query", type=pathlib.Path, help="a model for the command line")
    parser.add_argument("--searches", type=int, default=100)
    parser.add_argument("--runs", type=int, default=5, help="of the command line and of lists")
    arguments = parser.parse_args()
    figures = {"file_gb": arguments.index.stat().st_size / 1e9}
    server = Server(arguments.bin, arguments.index)
    try:
        figures["start_s"] = server.start_seconds
        figures["resident_at_start_mb"] = server.memory_mb()
        total = server.get("/v1/models?limit=1")["total"]
        figures["models"] = total
        choose = random.Random(1)
        places = choose.sample(range(total), arguments.searches + 10)
        ids = [server.get(f"/v1/models?limit=1&offset={place}")["models"][0]["id"]
               for place in places]
        ids, victims = ids[10:], ids[:10]
        by_id = [f"/v1/models/{each}/similar" for each in ids]
        figures["search_by_id"] = measure(server, by_id)
        of_class = []
        for each in ids[: max(5, len(ids) // 5)]:
            name = server.get(f"/v1/models/{each}")["class"]
            of_class.append(f"/v1/models/{each}/similar?class={name}")
        figures["search_with_class"] = measure(server, of_class)
        figures["resident_mb"] = server.memory_mb()
        for name, path in (("list", "/v1/models?limit=50"),
                           ("list_by_name", "/v1/models?limit=50&sort=name"),
                           ("list_named", "/v1/models?limit=50&name=12"),
                           ("facets", "/v1/facets")):
            first = times_ms(server.connect(), [path])[0]
            figures[name] = {"first_ms": first} | measure(server, [path] * arguments.runs)
        figures["resident_with_lists_mb"] = server.memory_mb()
        figures["writes"] = measure_writes(server, by_id, victims)
    finally:
        server.stop()
    if arguments.query:
        figures["command_line_beyond_describing_ms"] = measure_command_line(
            arguments.bin, arguments.index, arguments.query, arguments.runs)
    print(json.dumps(figures, indent=1))


if __name__ == "__main__":
    main()
