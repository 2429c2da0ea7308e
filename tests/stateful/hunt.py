"""Random sessions for as many minutes as asked, in processes of their own; each finding is reduced to few steps and printed.

    python tests/stateful/hunt.py MINUTES [SEED]
    python tests/stateful/hunt.py --replay '[["start", {"n": 3, "seed": 0}], ...]'

.ci/sanitize runs it with sanitizers. Ends with 1 if there was a finding.
"""

from __future__ import annotations

import contextlib
import faulthandler
import json
import os
import re
import sys
import tempfile
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from random import Random

import conftest  # noqa: F401  (finds the modules beside)
from session import LENGTH, Session, Steps, run, some_steps

SESSIONS = 50  # per process
LONGEST = 300.0  # s for one process that reduces; LONGEST * 10 for one that works
ATTEMPTS = 200  # removes steps of a finding


def work(seed: str, journal: Path, end: float) -> None:
    """Many sessions; the journal has the task at work."""
    for k in range(SESSIONS):
        if time.monotonic() > end:
            return
        steps = some_steps(Random(f"{seed}-{k}"))
        journal.write_text(json.dumps(steps))
        run(steps)


def replay(steps: Steps) -> None:
    Session.write_step = staticmethod(lambda step: print("   ", step, flush=True))
    run(steps)


# ---- processes -----------------------------------------------------------------------------------------------------------
def in_process(task: Callable[[], None], longest: float) -> tuple[bool, str]:
    """Return whether a task succeeded in a forked process with an empty folder, and its output."""
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile() as output:
        child = os.fork()
        if child == 0:
            os.chdir(folder)
            os.dup2(output.fileno(), 1)
            os.dup2(output.fileno(), 2)
            faulthandler.enable(2)
            code = 3
            with contextlib.suppress(BaseException):
                try:
                    task()
                    code = 0
                except BaseException:
                    traceback.print_exc()
                sys.stdout.flush()
                sys.stderr.flush()
            os._exit(code)
        status, hangs = wait(child, longest)
        output.seek(0)
        text = output.read().decode(errors="replace")
    return status == 0 and not hangs, text + ("\nFatal: hangs" if hangs else "")


def wait(child: int, longest: float) -> tuple[int, bool]:
    end = time.monotonic() + longest
    while time.monotonic() < end:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return status, False
        time.sleep(0.01)
    os.kill(child, 6)  # faulthandler shows the position
    return os.waitpid(child, 0)[1], True


# ---- findings ------------------------------------------------------------------------------------------------------------
def signature(text: str) -> str:
    """Properties that make two findings equal: the message of a sanitizer or exception, without numbers."""
    marks = r"SUMMARY: |runtime error: |Assertion.*failed|Finding: |^Fatal|^\w*Error"
    known = [line for line in text.splitlines() if re.search(marks, line)]
    return re.sub(r"0x[0-9a-f]+|-?\d+(\.\d+)?(e[+-]\d+)?", "#", known[-1] if known else text[-160:])[:160]


def reduced(steps: Steps, wanted: str) -> Steps:
    """Remove steps that the finding does not need."""
    size, attempts = len(steps) // 2, 0
    while size >= 1:
        at = 1
        while at < len(steps) and attempts < ATTEMPTS:
            fewer = [*steps[:at], *steps[at + size :]]
            fine, text = in_process(lambda fewer=fewer: run(fewer), LONGEST)
            attempts += 1
            if not fine and signature(text) == wanted:
                steps = fewer
            else:
                at += size
        size //= 2
    return steps


def hunt(minutes: float, seed: str) -> int:
    begin = time.monotonic()
    end, found, processes = begin + 60 * minutes, set(), 0
    with tempfile.TemporaryDirectory() as folder:
        journal = Path(folder) / "steps.json"
        while time.monotonic() < end:
            name = f"{seed}-{processes}"
            fine, text = in_process(lambda name=name: work(name, journal, end), 10 * LONGEST)
            processes += 1
            if fine or signature(text) in found:
                continue
            found.add(signature(text))
            steps = reduced([(name, draws) for name, draws in json.loads(journal.read_text())], signature(text))
            _, shown = in_process(lambda steps=steps: replay(steps), LONGEST)
            print(f"\n=== finding: {signature(text)}\n--replay '{json.dumps(steps)}'\n{shown[-8000:]}", flush=True)
    spent = (time.monotonic() - begin) / 60
    print(
        f"{spent:.0f} minutes, at most {processes * SESSIONS} sessions of {LENGTH} steps, seed {seed}: {len(found)} findings"
    )
    return 1 if found else 0


def main(arguments: list[str]) -> int:
    if arguments[0] == "--replay":
        replay([(name, draws) for name, draws in json.loads(arguments[1])])
        return 0
    return hunt(float(arguments[0]), arguments[1] if len(arguments) > 1 else os.urandom(4).hex())


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
