"""What a file of docs/evidence says of the run that wrote it."""
import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def told_by(*words):
    run = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    return run.stdout.strip() if run.returncode == 0 else "unknown"


def what_was_run(words, program):
    """The words ask the same again; the program is a full path."""
    return {"command": "./toccata " + " ".join(words), "version": told_by(program, "--version"), "commit": told_by("git", "describe", "--always", "--dirty"),
            "processors": os.cpu_count()}


def write_evidence(file, report):
    file.write_text(json.dumps(report, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
