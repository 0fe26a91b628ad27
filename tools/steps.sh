# The steps of ./toccata that are not needed when nothing changed. Sourced by it; expects source_folder to be set.
# Everything here speaks on standard error except the tests themselves.

say() { printf 'toccata: %s\n' "$*" >&2; }

# install_packages LIST…: installs what the lists tools/LIST.txt name and dpkg does not have.
install_packages() {
  command -v dpkg-query >/dev/null || return 0  # not Debian: CMake will tell what it cannot find
  local wanted missing
  wanted=$(cd "$source_folder/tools" && cat "${@/%/.txt}" | sort -u)
  # shellcheck disable=SC2086
  missing=$(comm -23 <(echo "$wanted") <(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' $wanted 2>/dev/null | sed -n 's/^ii //p' | sort -u) | xargs)
  [[ -n $missing ]] || return 0
  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      say "these packages are missing and only an administrator can install them: apt-get install $missing"
      return 2
    fi
    as_root=(sudo)
  fi
  say "installing $missing"
  # shellcheck disable=SC2086
  if ! { "${as_root[@]}" apt-get update -qq && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends $missing; } </dev/null >/dev/null; then
    say "could not install the packages; please install them yourself: apt-get install $missing"
    return 2
  fi
}

# One build at a time in one source folder; a second waits. Held until this process ends.
lock_build_folder() {
  mkdir -p "$source_folder/build"
  exec 9>"$source_folder/build/.lock"
  flock 9
}

# configure PRESET OPTION…: once, and again when the presets or the options are new.
configure() {
  local preset=$1 folder=$source_folder/build/$1 known="" wanted new=no
  shift
  # A clone that was copied or moved brings a build of another folder with it.
  if [[ -f $folder/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$source_folder" "$folder/CMakeCache.txt"; then
    rm -rf -- "$folder"
  fi
  if command -v ccache >/dev/null; then
    set -- "$@" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  wanted=("$(cksum <"$source_folder/CMakePresets.json")" "$@")
  if [[ -f $folder/build.ninja && -f $folder/.configured-with ]]; then known=$(<"$folder/.configured-with"); fi
  for word in "${wanted[@]}"; do [[ $known == *"$word"* ]] || new=yes; done
  [[ $new == yes ]] || return 0
  local output
  if ! output=$(cd "$source_folder" && cmake --preset "$preset" "$@" 2>&1); then
    say "configuring failed:"
    printf '%s\n' "$output" >&2
    return 2
  fi
  printf '%s\n' "${wanted[@]}" >"$folder/.configured-with"
}

# build PRESET TARGET…: one status line on a terminal; elsewhere nothing but what went wrong.
build() {
  local folder=$source_folder/build/$1 output
  shift
  [[ -f $folder/.ninja_log ]] || say "building; the first time takes a few minutes"
  if [[ -t 2 ]]; then
    ninja -C "$folder" "$@" >&2 9>&-
  elif ! output=$(ninja --quiet -C "$folder" "$@" 2>&1 9>&-); then
    printf '%s\n' "$output" >&2
    return 2
  fi
}

# run_tests [--all]: everything that judges a commit. The last thing printed is the summary of the tests, or of the
# part that failed.
run_tests() {
  if [[ ${1-} == --all ]]; then
    shift
    install_packages packages-test
    exec python3 "$source_folder/tools/test_all.py" "$@"
  elif [[ $# -gt 0 ]]; then
    say "test takes --all or nothing, not $*"
    return 2
  fi
  install_packages packages packages-test
  lock_build_folder
  say "the tests under the address and undefined-behaviour sanitizers"
  # The preset says what this pass leaves to --all. Precompiled headers and united files are for machines that begin from
  # nothing; the library is compiled once without them, so that its missing includes are told, and the builds of --all
  # have neither.
  local tests=() all=()
  if ! command -v ccache >/dev/null; then
    tests=(-DTOCCATA_UNITE_TESTS=ON)
    all=("${tests[@]}" -DTOCCATA_UNITE_LIBRARY=ON)
  fi
  configure asan-ubsan "${all[@]}"
  build asan-ubsan
  run_ctest asan-ubsan -E '^oracle/'  # the oracles' own tests need no sanitizer; the next step runs them
  say "all tests, optimised"
  configure release -DTOCCATA_BUILD_TESTS=ON -DTOCCATA_BUILD_BENCH=ON -DTOCCATA_BENCH_WITH_PEERS=OFF "${tests[@]}"
  build release
  run_ctest release
}

# run_ctest PRESET OPTION…: the tests built in build/PRESET; those that fail show what they printed.
run_ctest() {
  local folder=$source_folder/build/$1
  shift
  ctest --test-dir "$folder" --output-on-failure --timeout 300 -j "$(nproc)" "$@" 9>&-
}

# run_bench [--with-peers] WORD…: becomes the benchmark program. Without words after --with-peers it is only built.
run_bench() {
  local with_peers=no
  if [[ ${1-} == --with-peers ]]; then
    with_peers=yes
    shift
    install_packages packages-bench-peers
  fi
  install_packages packages packages-bench
  # In a process of its own, so that the lock does not stay with the program.
  (build_bench "$with_peers") || return 2
  if [[ $with_peers == yes && $# -eq 0 ]]; then return 0; fi
  exec "$source_folder/build/release/apps/bench/toccata-bench" "$@"
}

# build_bench yes|no: yes, so that CMake looks for the peers again.
build_bench() {
  lock_build_folder
  if [[ $1 == yes ]]; then rm -f "$source_folder/build/release/.configured-with"; fi
  configure release -DTOCCATA_BUILD_BENCH=ON -DTOCCATA_BENCH_WITH_PEERS=ON && build release toccata_bench
}
