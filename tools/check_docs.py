#!/usr/bin/env python3
"""Checks that what the documentation shows is true.

usage: check_docs.py --prefix DIR --compiler CXX [FILE.md…]

DIR is where the library and the command are installed. In README.md, CONTRIBUTING.md, CHANGELOG.md, examples/README.md
and docs/ (or the files named):

  ```cpp run     compiled against the library and run; what it prints must be the ```output block after it. Those that
                 include the same are one program, each in a namespace of its own, so main is the last thing in each
  ```cpp         compiled: as it is when it has a main, otherwise as the inside of a function
  ```sh run      run by bash in a folder that all blocks of one file share, with the installed command first on PATH;
                 compared with the ```output block after it, if any. `exit=1` after `run` is the status expected.
  ```json        parsed

In an output block … stands for anything within a line, and a line … for any number of lines. Links between files and to
headings must lead somewhere, also the docs/….md that C++ comments name.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Pages that are not in docs/.
OUTSIDE_DOCS = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "examples/README.md"]
FIRST_HEADERS = ["<toccata/methods.hpp>", "<toccata/toccata.hpp>"]
# So that two cores have as much to do.
MOST_JOINED = 26
FENCE = re.compile(r"^```([^\n`]*)\n(.*?)^```\s*$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+\s+(.*)$", re.MULTILINE)
NAMED_IN_SOURCE = re.compile(r"\bdocs/[\w/.-]+\.md\b")


def is_include(line):
    return line.startswith("#include")


class Block:
    def __init__(self, file, line, info, text, output):
        self.file, self.line, self.info, self.text, self.output = file, line, info.split(), text, output
        self.language = self.info[0] if self.info else ""
        self.runs = "run" in self.info
        self.status = next((int(w[5:]) for w in self.info if w.startswith("exit=")), 0)
        self.program = None  # of a block that is run: the words that run it, once it is compiled

    def is_program(self):
        return self.language == "cpp" and self.runs

    def includes(self):
        return tuple(sorted(filter(is_include, self.text.split("\n"))))

    def where(self):
        return f"{self.file.relative_to(ROOT) if self.file.is_relative_to(ROOT) else self.file}:{self.line}"


def blocks(file):
    text = file.read_text()
    found = []
    for match in FENCE.finditer(text):
        info, content = match.group(1).strip(), match.group(2)
        if info == "output" and found:
            found[-1].output = content
        else:
            found.append(Block(file, text.count("\n", 0, match.start()) + 1, info, content, None))
    return found


def matches(expected, printed):
    """Whether `printed` is what an output block shows, … being a wildcard."""
    pattern = ""
    for line in expected.rstrip("\n").split("\n"):
        pattern += r"(?:[^\n]*\n)*" if line.strip() == "…" else re.escape(line.rstrip()).replace("…", "[^\n]*") + r"[ ]*\n"
    return re.fullmatch(pattern, printed.rstrip("\n") + "\n") is not None


def joined(blocks):
    """One program of all blocks, which runs that whose number it is given."""
    pieces = list(blocks[0].includes())
    for number, block in enumerate(blocks):
        body = "\n".join("" if is_include(line) else line for line in block.text.rstrip().split("\n"))
        opened, _, _ = body.replace("int main(", "int snippet_main(", 1).rpartition("}")
        pieces.append(f'namespace snippet{number} {{\n#line {block.line + 1} "{block.file}"\n{opened}\n  return 0;\n}}\n}}')
    cases = "".join(f"    case {number}: return snippet{number}::snippet_main();\n" for number in range(len(blocks)))
    pieces.append(f"#include <cstdlib>\nint main(int, char** words) {{\n  switch (std::atoi(words[1])) {{\n{cases}    default: return 77;\n  }}\n}}\n")
    return "\n".join(pieces)


class Checker:
    def __init__(self, prefix, compiler, folder):
        self.prefix, self.compiler, self.folder, self.precompiled = prefix.resolve(), compiler, folder, folder / "first.hpp"
        environment = {**os.environ, "PKG_CONFIG_PATH": str(next(self.prefix.rglob("pkgconfig")))}
        ask = ["pkg-config", "--cflags", "--libs", "toccata-reports"]
        self.flags = subprocess.run(ask, env=environment, check=True, capture_output=True, text=True).stdout.split()
        self.environment = {**os.environ, "PATH": f"{self.prefix}/bin:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
        self.precompile()

    def precompile(self):
        """The two headers that most programs include, compiled once."""
        self.precompiled.write_text("".join(f"#include {name}\n" for name in FIRST_HEADERS))
        made = self.precompiled.with_suffix(".hpp.gch")
        subprocess.run([self.compiler, "-std=c++20", "-c", "-x", "c++-header", self.precompiled, "-o", made, *self.flags], check=True)

    def first(self, text):
        """Compiler options: the precompiled headers, where the text includes them itself."""
        return ["-include", self.precompiled] if all(f"#include {name}\n" in text for name in FIRST_HEADERS) else []

    def compile(self, text, source, want):
        """What the compiler complains of, or None."""
        source.write_text(text)
        warnings = ["-Wall", "-Wextra", "-Werror", "-Wno-unused", "-Wno-unused-command-line-argument"]
        run = subprocess.run([self.compiler, "-std=c++20", *warnings, *self.first(text), source, *want, *self.flags], capture_output=True, text=True)
        return None if run.returncode == 0 else f"does not compile\n{run.stderr}"

    def compile_together(self, blocks, name):
        """Makes the program of blocks that include the same; the complaints."""
        source = self.folder / f"{name}.cpp"
        complaint = self.compile(joined(blocks), source, ["-o", source.with_suffix("")])
        if complaint:
            return [f"{blocks[0].where()}, with others that include the same: {complaint}"]
        for number, block in enumerate(blocks):
            block.program = [source.with_suffix(""), str(number)]
        return []

    def compile_programs(self, pages, pool):
        """Makes all programs, those of the most blocks first."""
        alike = {}
        for block in (b for page in pages for b in page if b.is_program()):
            alike.setdefault(block.includes(), []).append(block)
        programs = [same[i:i + MOST_JOINED] for same in alike.values() for i in range(0, len(same), MOST_JOINED)]
        found = pool.map(self.compile_together, sorted(programs, key=len, reverse=True), range(len(programs)))
        return [complaint for complaints in found for complaint in complaints]

    def compare(self, block, run):
        if run.returncode != block.status:
            return f"{block.where()}: exit status {run.returncode} instead of {block.status}\n{run.stdout}{run.stderr}"
        if block.output is not None and not matches(block.output, run.stdout):
            return f"{block.where()}: prints something else than the documentation says:\n{run.stdout}{run.stderr}"
        return None

    def check_cpp(self, block, folder):
        if block.runs:
            if block.program is None:
                return None  # its complaint is known
            return self.compare(block, subprocess.run(block.program, cwd=folder, env=self.environment, capture_output=True, text=True))
        text = block.text
        if "int main(" not in text:
            body = [line for line in text.split("\n") if not is_include(line)]
            text = "\n".join([*block.includes(), "void snippet() {", *body, "}"])
        complaint = self.compile(text, folder / f"snippet{block.line}.cpp", ["-fsyntax-only"])
        return complaint and f"{block.where()}: {complaint}"

    def check_sh(self, block, folder):
        run = subprocess.run(["bash", "-c", block.text], cwd=folder, env=self.environment, capture_output=True, text=True,
                             stdin=subprocess.DEVNULL)
        return self.compare(block, run)

    def check_json(self, block):
        try:
            json.loads(block.text)
        except ValueError as error:
            return f"{block.where()}: is not JSON: {error}"
        return None

    def check_page(self, page):
        complaints = []
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for block in page:
                if block.language == "cpp":
                    complaints.append(self.check_cpp(block, folder))
                elif block.language == "sh" and block.runs:
                    complaints.append(self.check_sh(block, folder))
                elif block.language == "json":
                    complaints.append(self.check_json(block))
        return [c for c in complaints if c]


def anchor(heading):
    """The name under which GitHub links to a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def check_links(file):
    text = FENCE.sub("", file.read_text())
    for target in LINK.findall(text):
        if "://" in target or target.startswith("mailto:"):
            continue
        path, _, heading = target.partition("#")
        linked = (file.parent / path).resolve() if path else file
        if not linked.exists():
            yield f"{file.relative_to(ROOT)}: links to {target}, which does not exist"
        elif heading and heading not in map(anchor, HEADING.findall(FENCE.sub("", linked.read_text()))):
            yield f"{file.relative_to(ROOT)}: links to {target}, and there is no such heading"


def check_names_in_sources():
    for folder in ["include", "src", "apps", "tests", "cmake"]:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in {".hpp", ".cpp", ".txt"}:
                for name in NAMED_IN_SOURCE.findall(path.read_text()):
                    if not (ROOT / name).exists():
                        yield f"{path.relative_to(ROOT)}: names {name}, which does not exist"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--prefix", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    files = [f.resolve() for f in options.files]
    complaints = []
    if not files:
        files = [f for f in [*(ROOT / name for name in OUTSIDE_DOCS), *sorted((ROOT / "docs").rglob("*.md"))] if f.exists()]
        complaints = [c for f in files for c in check_links(f)] + list(check_names_in_sources())
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        checker = Checker(options.prefix, options.compiler, pathlib.Path(name))
        pages = [blocks(file) for file in files]
        complaints += checker.compile_programs(pages, pool)
        for found in pool.map(checker.check_page, pages):
            complaints += found
    for complaint in complaints:
        print(complaint)
    count = sum(map(len, pages))
    print(f"docs: {len(files)} files, {count} blocks, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
