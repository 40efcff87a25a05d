#!/usr/bin/env python3
"""Runs rungproof over a folder of a public suite and prints what it says beside what is known.

usage: run.py FOLDER [--rungproof FILE] [--timeout SECONDS] [--json FILE] [--only TEXT]

The suites are not part of the repository. Tasks are found by what lies in the folder:
  test.desc            ESBMC regression tests: program, properties (props.yaml) and the expected line
  malicious, legitimate   programs of logic-bomb datasets (.st, and .xml where there is no text): the question is
                       whether a scan can fail to end, or an error at run time can happen (--builtin)
  props.yaml alone     programs beside it; what their names say (safe, unsafe) is known, the rest is not
A task is right if the verdict is the known one. What is refused or not covered is never right.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

SAFE, UNSAFE, OPEN = "safe", "violated", "undecided"


def properties_of(text):
    """The rows of a props.yaml: '- key: value' begins one."""
    rows = []
    for line in text.splitlines():
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        first = re.match(r"\s*-\s+(\w+):\s*(.*)", line)
        more = re.match(r"\s+(\w+):\s*(.*)", line)
        if first:
            rows.append({first.group(1): first.group(2).strip().strip('"')})
        elif more and rows:
            rows[-1][more.group(1)] = more.group(2).strip().strip('"')
    return rows


def expression(text):
    """C operators as words; `a__b` is the part b of a."""
    for old, new in (("&&", " and "), ("||", " or "), ("==", "="), ("!=", "<>"), ("->", " implies ")):
        text = text.replace(old, new)
    return re.sub(r"(\w+?)__(\w+)", r"\1.\2", re.sub(r"!(?!=)", " not ", text))


def statements_of(rows):
    """The same as statements of a property file; None where a kind is not known."""
    lines = []
    for row in rows:
        kind, name = row.get("kind"), row.get("id", "P")
        if kind == "invariant":
            lines.append(f"prove {name}: {expression(row['expression'])}")
        elif kind in ("absence", "reachability"):
            lines.append(f"prove {name}: never ({expression(row['expression'])})")
        elif kind == "mutual_exclusion":
            names = [part.strip() for part in row["variables"].strip("[]").split(",")]
            pairs = [f"({a} and {b})" for i, a in enumerate(names) for b in names[i + 1:]]
            lines.append(f"prove {name}: never ({' or '.join(pairs)})")
        elif kind == "response":
            scans = row.get("max_scans", "1")
            lines.append(f"prove {name}: {expression(row['trigger'])} leads to {expression(row['response'])} "
                         f"within {scans} scans")
        elif kind is not None:
            return None
    return "\n".join(lines) + "\n"


def tasks_in(folder):
    """(program, known verdict or None, property text or None for --builtin)"""
    for desc in sorted(folder.rglob("test.desc")):
        lines = desc.read_text(errors="replace").splitlines()
        if len(lines) < 4:
            continue
        known = SAFE if "SUCCESSFUL" in lines[3] else UNSAFE if "FAILED" in lines[3] else None
        if "--ld-fault-injection" in lines[2]:  # asks of another program: with values that a fault has changed
            known = None
        if "--ld-scan-budget" in lines[2] and known == UNSAFE:  # asks how many rounds a scan has, not what is written
            known = None
        props = desc.parent / "props.yaml"
        wanted = statements_of(properties_of(props.read_text())) if props.exists() else None
        yield desc.parent / lines[1].strip(), known, wanted
    for kind, known in (("malicious", UNSAFE), ("legitimate", SAFE)):
        for root in sorted(path for path in folder.rglob(kind) if path.is_dir()):
            texts = sorted(root.rglob("*.st"))
            for program in texts or sorted(root.rglob("*.xml")):
                if "fault_code" in program.parts:  # other behaviour, in which every scan ends
                    yield program, None, None
                    continue
                yield program, known, None
    for props in sorted(folder.rglob("props*.yaml")):
        if (props.parent / "test.desc").exists():
            continue
        wanted = statements_of(properties_of(props.read_text()))
        for program in sorted(path for path in props.parent.iterdir() if path.suffix in (".ld", ".st", ".xml")):
            name = program.stem
            known = UNSAFE if "unsafe" in name else SAFE if name.endswith("safe") else None
            yield program, known, wanted


def answer(options, program, wanted):
    """Our verdict, what certifies it, seconds, and the reason where there is none."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = [options.rungproof, "prove", str(program), "--dialect", "iec", "--isolated", "--format", "json"]
        if wanted is None:
            arguments.append("--builtin")
        else:
            path = pathlib.Path(folder) / "asked.prop"
            path.write_text(wanted)
            arguments += ["--props", str(path)]
        begin = time.monotonic()
        try:
            done = subprocess.run(arguments, capture_output=True, text=True, timeout=options.timeout)
        except subprocess.TimeoutExpired:
            return OPEN, "", options.timeout, "no answer in time"
        seconds = time.monotonic() - begin
    try:
        report = json.loads(done.stdout)
    except ValueError:
        return OPEN, "", seconds, (done.stderr.strip().splitlines() or ["no report"])[0]
    verdicts = [row["verdict"] for row in report["properties"]]
    errors = [f["message"] for f in report["findings"] if f["severity"] == "error" and f["rule"].startswith("SYN")]
    if any(v in ("VIOLATED", "REACHABLE") for v in verdicts):
        return UNSAFE, "run repeated by the engine", seconds, ""
    if done.returncode == 0 and verdicts and all(v in ("PROVED", "UNREACHABLE") for v in verdicts):
        return SAFE, "certificate checked", seconds, ""
    reason = errors[0] if errors else ", ".join(sorted(set(verdicts))) or "nothing was asked"
    return OPEN, "", seconds, reason


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rungproof", default="build/release/rungproof")
    parser.add_argument("--timeout", type=float, default=20)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    rows, tally = [], collections.Counter()
    for program, known, wanted in tasks_in(options.folder):
        name = str(program.relative_to(options.folder))
        if options.only not in name:
            continue
        ours, shown_by, seconds, reason = answer(options, program, wanted)
        kind = "unknown before" if known is None else "right" if ours == known else \
            "undecided" if ours == OPEN else "CONTRADICTS"
        tally[kind] += 1
        rows.append({"task": name, "known": known, "ours": ours, "seconds": round(seconds, 3),
                     "shown_by": shown_by, "reason": reason})
        print(f"{kind:14} known {str(known):9} ours {ours:9} {seconds:7.3f} s  {name}"
              + (f"  ({shown_by or reason})" if shown_by or reason else ""), flush=True)
    times = sorted(row["seconds"] for row in rows)
    median = times[len(times) // 2] if times else 0
    print(f"{len(rows)} tasks: " + ", ".join(f"{count} {kind}" for kind, count in sorted(tally.items()))
          + f"; median {median:.3f} s, longest {times[-1] if times else 0:.3f} s")
    if options.json:
        options.json.write_text(json.dumps({"tasks": rows, "summary": dict(tally)}, indent=1) + "\n")
    return 1 if tally["CONTRADICTS"] else 0


if __name__ == "__main__":
    sys.exit(main())
