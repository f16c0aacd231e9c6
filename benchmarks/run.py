"""Run benchmarks and print one table: ``tandem bench``, or ``python -m benchmarks.run``.

A benchmark is a module of this folder with a function ``rows()``, or ``rows(*, quick)``, that returns
``benchmarks.rows.Row``s. Each runs in a process of its own, one after the other; a quick run asks each for
its short form and leaves out those that have none.
"""

from __future__ import annotations

import argparse
import dataclasses
import importlib
import inspect
import json
import re
import subprocess
import sys
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

from benchmarks.machine import Others, describe
from benchmarks.rows import Row
from tandem.executive.trials.provenance import provenance

HERE = Path(__file__).parent
MISSED = 1
AT_MOST = 900.0
"""Seconds for one benchmark."""
_HAS_ROWS = re.compile(r"^def rows\(", re.MULTILINE)
_HAS_QUICK = re.compile(r"^def rows\([^)]*\bquick\b", re.MULTILINE)
_HEAD = ("what", "value", "unit", "aim", "value to aim", "others' cores", "note")
_HOW = (
    "`value to aim` is at most 1 if the target is met. `others' cores` is how many cores other programs kept"
    " busy while it was measured: times taken beside others are longer than on a machine left alone."
)


def names(*, quick: bool = False) -> list[str]:
    """Return the benchmarks there are; with ``quick``, those that have a short form."""
    wanted = _HAS_QUICK if quick else _HAS_ROWS
    return sorted(path.stem for path in HERE.glob("*.py") if wanted.search(path.read_text(encoding="utf-8")))


def measure(name: str, *, quick: bool = False) -> list[Row]:
    """Return a benchmark's rows, measured in a process of its own.

    Raises:
        RuntimeError: with the last words of a benchmark that failed.
    """
    argv = [sys.executable, "-m", "benchmarks.run", "--one", name, *(["--quick"] if quick else [])]
    others = Others()
    try:
        done = subprocess.run(  # noqa: S603 - our own code
            argv, capture_output=True, text=True, check=False, cwd=HERE.parent, timeout=AT_MOST
        )
    except subprocess.TimeoutExpired as late:
        raise RuntimeError(f"{name}: not done within {AT_MOST:.0f} s") from late
    if done.returncode:
        raise RuntimeError(f"{name}: {done.stderr.strip()[-2000:]}")
    busy = others.cores()
    rows = [Row(**row) for row in json.loads(done.stdout.splitlines()[-1])]
    return [dataclasses.replace(row, others=busy) for row in rows]


def table(rows: Sequence[Row]) -> str:
    """Return the rows as a Markdown table."""
    lines = [_HEAD, ("---",) * len(_HEAD)]
    for row in rows:
        aim = "" if row.aim is None else f"{'≥' if row.more else '≤'} {row.aim:g}"
        ratio = "" if row.ratio is None else f"{row.ratio:.2f}"
        others = "" if row.others is None else f"{row.others:.1f}"
        lines.append((row.what, f"{row.value:.4g}", row.unit, aim, ratio, others, row.note))
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def page(where: str, rows: Sequence[Row]) -> str:
    """Return the documentation's page of figures."""
    parts = ("# Benchmarks", "Made by `tandem bench --markdown FILE`; don't edit.", where, _HOW, table(rows))
    return "\n\n".join(parts) + "\n"


def main(argv: list[str]) -> int:
    """Measure and print; return 0 when all benchmarks ran (figures are not judged here)."""
    given, parser = _arguments(argv)
    if given.one:
        print(json.dumps([dataclasses.asdict(row) for row in _rows_of(given.one, quick=given.quick)]))
        return 0
    there = names(quick=given.quick)
    if given.list:
        print("\n".join(there))
        return 0
    unknown = [name for name in given.names if name not in there]
    if unknown:
        parser.error(f"no benchmark {', '.join(unknown)}; there are {', '.join(there)}")
    made = provenance(("tandem", "bench", *argv), time.time())
    where, rows, failed = describe(), list[Row](), False
    for name in given.names or there:
        print(f"{name} ...", file=sys.stderr, flush=True)
        try:
            rows += measure(name, quick=given.quick)
        except RuntimeError as error:
            failed = True
            print(error, file=sys.stderr)
    print(f"{where}\n\n{table(rows)}")
    if given.report is not None:
        document = {
            "made": made.model_dump(mode="json"),
            "machine": where,
            "rows": [dataclasses.asdict(row) for row in rows],
        }
        _write(given.report, f"{json.dumps(document, indent=2)}\n")
    if given.markdown is not None:
        _write(given.markdown, page(f"{made.line()}.\n\n{where}", rows))
    return MISSED if failed else 0


def _arguments(argv: list[str]) -> tuple[argparse.Namespace, argparse.ArgumentParser]:
    parser = argparse.ArgumentParser(prog="tandem bench", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="which benchmarks; all unless given")
    parser.add_argument("--list", action="store_true", help="print the names and end")
    parser.add_argument("--quick", action="store_true", help="short forms: that they run, not what they say")
    parser.add_argument("--report", type=Path, metavar="FILE", help="write the figures as JSON")
    parser.add_argument("--markdown", type=Path, metavar="FILE", help="write the figures as a page")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    return parser.parse_args(argv), parser


def _rows_of(name: str, *, quick: bool) -> Iterable[Row]:
    rows = importlib.import_module(f"benchmarks.{name}").rows
    found: Iterable[Row] = rows(quick=quick) if "quick" in inspect.signature(rows).parameters else rows()
    return found


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
