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
# run_tests OPTIONS WORD…: pytest, with these options of the address sanitizer besides.
run_tests() {
  env LD_PRELOAD="$runtime" PYTHONPATH="$site" ASAN_OPTIONS="detect_leaks=0:$1" UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 PYTHONMALLOC=malloc \
    "$python" -m pytest -q -p no:cacheprovider "${@:2}"
}
tests=python/tests
gives_back=$tests/test_robustness.py::test_memory_is_given_back
cd "$root"  # to which the name of the test that is left out is relative
# Not those that measure memory or times, start other programs, or ask for stubs.
run_tests "" "$tests" --ignore="$tests/test_memory.py" --ignore="$tests/test_drop_ins.py" --ignore="$tests/test_types.py" \
  --deselect="$gives_back" "${@:2}"
# Memory that is given back waits in the sanitizer's quarantine, which must not grow meanwhile.
run_tests quarantine_size_mb=1:thread_local_quarantine_size_kb=64 "$gives_back"
