#!/usr/bin/env bash
# test_python_sanitized.sh FOLDER [OPTION…]: the tests of the Python package with its compiled part under the address and
# undefined-behaviour sanitizers, against the libraries under sanitizers that lie in FOLDER (TOCCATA_TEST_SANITIZED). Only
# the bindings are compiled, in build/python/sanitized. What Python itself never frees is no leak of ours.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
libraries=$(cd "$1" && pwd)
if [[ ! -f $libraries/libtoccata_reports_sanitized.so ]]; then
  echo "there are no libraries under sanitizers in $libraries: configure it with -DTOCCATA_TEST_SANITIZED=ON and build toccata_reports_sanitized" >&2
  exit 2
fi
folder=$root/build/python/sanitized
python=$root/build/python/asan/bin/python
if ! "$python" -c 'import nanobind, numpy, pytest, hypothesis, scipy' 2>/dev/null; then
  python3 -m venv "$root/build/python/asan"
  "$python" -m pip install --quiet --disable-pip-version-check 'nanobind >= 3.1, < 4' numpy pytest hypothesis scipy
fi
# Each time: the libraries may be others than the last time, and what is as it was is not compiled again.
cmake -G Ninja -S "$root/python" -B "$folder" -DCMAKE_BUILD_TYPE=None -DTOCCATA_SANITIZED_BUILD="$libraries" -DPython_EXECUTABLE="$python" >/dev/null
ninja -C "$folder"
site=$(mktemp -d)
trap 'rm -rf -- "$site"' EXIT
cp -r "$root/python/toccata" "$site/toccata"
rm -f "$site"/toccata/_core*.so
cp "$folder"/_core*.so "$site/toccata/"
runtime=$(g++ -print-file-name=libasan.so):$(g++ -print-file-name=libubsan.so):$(g++ -print-file-name=libstdc++.so.6)
# Not those that measure memory or times, start other programs, or ask for stubs. (Memory given back waits in a quarantine.)
env LD_PRELOAD="$runtime" PYTHONPATH="$site" ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 PYTHONMALLOC=malloc \
  "$python" -m pytest -q -p no:cacheprovider "$root/python/tests" \
  --ignore="$root/python/tests/test_memory.py" --ignore="$root/python/tests/test_drop_ins.py" --ignore="$root/python/tests/test_types.py" \
  --deselect="$root/python/tests/test_threads.py::test_import_brings_nothing_but_numpy" \
  --deselect="$root/python/tests/test_robustness.py::test_memory_is_given_back" "${@:2}"
