#!/usr/bin/env python3
"""Measures the programs on the worst cases: time and memory of each command, stage by stage.

    ossuary_worst_cases FOLDER
    run_worst_cases.py --bin build/release/bin --cases FOLDER --out docs/benchmarks/worst_cases.csv

Each row is one run of one command in a process of its own: seconds on the wall, processor seconds (user and
system), the largest resident memory, how it ended (the exit status and the code of the error, if any),
warnings, and the milliseconds of the stages that the command reports. `search` looks in an index of the small
versions of the same models (ossuary_worst_cases FOLDER/small --small). `server` posts the model to a server of its
own as a search, with a timeout of five seconds: the clock is the answer's, time and memory are the server's whole.
"""

import argparse
import csv
import http.client
import json
import os
import pathlib
import platform
import re
import signal
import subprocess
import sys
import tempfile
import time

COMMANDS = ("skeleton", "segment", "index", "search", "server")
REQUEST_TIMEOUT_S = 5
LARGEST_FILE = 256 << 20  # as the command line takes them
COLUMNS = ("case", "command", "megabytes", "wall_s", "processor_s", "peak_mb", "exit", "outcome", "warnings",
           "stages_ms", "machine")


def machine():
    """What the figures were measured on."""
    model = platform.machine()
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1].strip()
            break
    return f"{os.cpu_count()} cores, {model}"


def run(command, limit_s):
    """Runs a command to its end; its clock, its own use of resources and what it printed."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begin = time.monotonic()
        process = subprocess.Popen(command, stdout=out, stderr=err)
        killed = False
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() - begin > limit_s and not killed:
                process.kill()
                killed = True
            time.sleep(0.005)
        wall = time.monotonic() - begin
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        return {
            "wall_s": round(wall, 2),
            "processor_s": round(usage.ru_utime + usage.ru_stime, 2),
            "peak_mb": round(usage.ru_maxrss / 1024),
            "exit": "killed" if killed else process.returncode,
            "out": out.read().decode("utf-8", "replace"),
            "err": err.read().decode("utf-8", "replace"),
        }


def document_of(text):
    try:
        return json.loads(text)
    except json.JSONDecodeError:
        return {}


def stages_of(document):
    """The milliseconds of each stage in one cell; commands write them as an object or as a list."""
    stages = document.get("stages_ms", {})
    if isinstance(stages, list):
        stages = {stage["stage"]: stage["milliseconds"] for stage in stages}
    return " ".join(f"{name}={value:.0f}" for name, value in stages.items())


def error_code(text):
    """The code of the error or of the failed model that a command reports."""
    found = re.search(r"\b(?:error|failed)[^\n]*?\b([a-z]+(?:_[a-z]+)+|cancelled|internal)\b", text)
    return found.group(1) if found else ""


def measure(command, case, programs, small_index, limit_s):
    ossuary = str(programs / "ossuary")
    with tempfile.TemporaryDirectory() as folder:
        if command == "index":
            arguments = ["index", "--index", f"{folder}/one.ossuary", "--jobs", "1", "--json", str(case)]
        elif command == "search":
            arguments = ["search", "--index", small_index, "--json", str(case)]
        else:
            arguments = [command, "--json", str(case)]
        row = run([ossuary, *arguments], limit_s)
    document = document_of(row.pop("out"))
    text = row.pop("err")
    row["outcome"] = "done" if row["exit"] == 0 else error_code(text)
    row["warnings"] = " ".join(w["code"] for w in document.get("warnings", []))
    row["stages_ms"] = stages_of(document)
    if row["exit"] not in (0, "killed"):
        print(text.strip().splitlines()[-1:], file=sys.stderr)
    return row


def measure_server(case, programs, small_index, limit_s):
    """One search by upload, of a server that is started for it and ends after it."""
    command = [str(programs / "ossuary-server"), "--index", small_index, "--port", "0", "--log-level", "off",
               "--request-timeout", str(REQUEST_TIMEOUT_S), "--max-upload-bytes", str(LARGEST_FILE)]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    port = int(server.stdout.readline().decode().rsplit(":", 1)[1])
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=limit_s)
    begin = time.monotonic()
    try:
        # As a stream: what this process holds counts as its children's peak.
        with case.open("rb") as model:
            connection.request("POST", "/v1/search", model, {"Content-Length": str(case.stat().st_size)})
        answer = connection.getresponse()
        document, status = document_of(answer.read()), answer.status
    except (OSError, http.client.HTTPException):
        document, status = {}, "no answer"
    wall = time.monotonic() - begin
    connection.close()
    server.send_signal(signal.SIGTERM)
    _, ended, usage = os.wait4(server.pid, 0)
    server.returncode = os.waitstatus_to_exitcode(ended)
    server.stdout.close()
    return {
        "wall_s": round(wall, 2),
        "processor_s": round(usage.ru_utime + usage.ru_stime, 2),
        "peak_mb": round(usage.ru_maxrss / 1024),
        "exit": server.returncode,
        "outcome": "done" if status == 200 else document.get("code", status),
        "warnings": " ".join(w["code"] for w in document.get("warnings", [])),
        "stages_ms": stages_of(document),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, required=True, help="folder of the programs")
    parser.add_argument("--cases", type=pathlib.Path, required=True, help="what ossuary_worst_cases wrote")
    parser.add_argument("--out", type=pathlib.Path, help="CSV to write")
    parser.add_argument("--only", nargs="*", default=[], help="names of cases")
    parser.add_argument("--commands", nargs="*", default=COMMANDS, choices=COMMANDS)
    parser.add_argument("--limit", type=float, default=300, help="seconds until a run is killed")
    options = parser.parse_args()

    named = machine()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        small_index = f"{folder}/small.ossuary"
        if {"search", "server"} & set(options.commands):
            subprocess.run([options.bin / "ossuary", "index", "--index", small_index, options.cases / "small"],
                           check=True, capture_output=True)
        for case in sorted(options.cases.glob("*.off")):
            if options.only and case.stem not in options.only:
                continue
            for command in options.commands:
                row = {"case": case.stem, "command": command, "machine": named,
                       "megabytes": round(case.stat().st_size / 1e6, 1)}
                row |= (measure_server(case, options.bin, small_index, options.limit) if command == "server" else
                        measure(command, case, options.bin, small_index, options.limit))
                rows.append(row)
                print(" ".join(f"{row[column]}" for column in COLUMNS[:-1]), flush=True)
    if options.out:
        with open(options.out, "w", newline="", encoding="utf-8") as out:
            writer = csv.DictWriter(out, fieldnames=COLUMNS)
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
