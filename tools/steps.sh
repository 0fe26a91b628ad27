# The steps of ./toccata that are not needed when nothing changed. Sourced by it; expects source_folder to be set.
# Everything here speaks on standard error except the tests themselves.

say() { printf 'toccata: %s\n' "$*" >&2; }

# show_progress SECONDS: what it reads are lines that tell how far a step is. On a terminal the newest stands alone and is
# overwritten; elsewhere one is printed every SECONDS, so that a log stays short and is never silent.
show_progress() {
  local line started=$SECONDS next=$((SECONDS + $1)) on_terminal=no
  if [[ -t 2 ]]; then on_terminal=yes; fi
  while IFS= read -r line; do
    if [[ $on_terminal == yes ]]; then
      printf '\r\e[K%.*s' "${COLUMNS:-100}" "toccata: $line ($((SECONDS - started)) s)" >&2
    elif ((SECONDS >= next)); then
      say "$line ($((SECONDS - started)) s)"
      next=$((SECONDS + $1))
    fi
  done
  if [[ $on_terminal == yes ]]; then printf '\r\e[K' >&2; fi
}

# install_packages LIST…: installs what the lists tools/LIST.txt name and dpkg does not have.
install_packages() {
  # shellcheck disable=SC2046
  install_named $(cd "$source_folder/tools" && cat "${@/%/.txt}")
}

# install_named PACKAGE…
install_named() {
  [[ $# -gt 0 ]] || return 0
  command -v dpkg-query >/dev/null || return 0  # not Debian: CMake will tell what it cannot find
  local missing
  missing=$(comm -23 <(printf '%s\n' "$@" | sort -u) <(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' "$@" 2>/dev/null | sed -n 's/^ii //p' | sort -u) | xargs)
  [[ -n $missing ]] || return 0
  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      say "these packages are missing and only an administrator can install them: apt-get install $missing"
      return 2
    fi
    as_root=(sudo)
  fi
  say "installing $(wc -w <<<"$missing") packages and what they need: $missing"
  local log
  log=$(mktemp)
  # shellcheck disable=SC2086
  if ! {
    "${as_root[@]}" apt-get update &&
      "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
  } </dev/null 2>&1 | tee "$log" | sed -un 's/^\(Get:[0-9]*\) [^ ]* [^ ]* [^ ]* \([^ ]*\).*/installing: fetching \2/p; s/^\(Unpacking\|Setting up\) \([^ :]*\).*/installing: \1 \2/p' | show_progress 15; then
    tail -n 20 "$log" >&2
    say "could not install the packages; please install them yourself: apt-get install $missing"
    return 2
  fi
  rm -- "$log"
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
  # Not in a folder that was begun without: all that is built there would be compiled again.
  if command -v ccache >/dev/null && { [[ ! -f $folder/build.ninja ]] || grep -qs ccache "$folder/CMakeCache.txt"; }; then
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

# build PRESET TARGET…: says how far it is, and of a failure what the compiler said.
build() {
  local folder=$source_folder/build/$1 log
  shift
  log=$(mktemp)
  if ! NINJA_STATUS='[%f/%t] ' ninja -C "$folder" "$@" 2>&1 9>&- | tee "$log" | sed -un 's/^\[\([0-9]*\)\/\([0-9]*\)\] .*/building: \1 of \2 steps/p' | show_progress 15; then
    grep -v '^\[[0-9]*/[0-9]*\] ' "$log" >&2 || true
    return 2
  fi
  rm -- "$log"
}

# add_formats step|ifc|assimp…: the programs by which the command reads these formats.
add_formats() {
  local format
  if [[ $# -eq 0 ]]; then
    say "name the formats to add: step, ifc, assimp"
    return 2
  fi
  for format in "$@"; do
    case $format in
      step)
        install_packages packages packages-step
        lock_build_folder
        configure release -DTOCCATA_WITH_STEP=ON
        build release toccata_command toccata_read_step
        ;;
      ifc)
        add_ifc
        ;;
      assimp)
        install_packages packages packages-assimp
        lock_build_folder
        configure release -DTOCCATA_WITH_ASSIMP=ON
        build release toccata_command toccata_read_assimp
        ;;
      *)
        say "there is no format $format to add: step, ifc, assimp (OBJ, STL, PLY, OFF, glTF, GLB and 3MF are always read)"
        return 2
        ;;
    esac
    say "files of $format are read now: ./toccata check FILE"
  done
}

# IfcOpenShell in a Python of its own, and a program that runs it.
add_ifc() {
  local python=$source_folder/build/formats/ifc program=$source_folder/build/release/apps/toccata/toccata-read-ifc
  python3 -m venv "$python" && "$python/bin/pip" install --quiet ifcopenshell >&2
  mkdir -p "$(dirname "$program")"
  printf '#!/usr/bin/env bash\nexec %q %q "$@"\n' "$python/bin/python" "$source_folder/apps/formats/read_ifc.py" >"$program"
  chmod +x "$program"
}

# A second reader of BCF in a Python of its own, and buildingSMART's schemas of it, which the sources of an earlier version hold.
add_bcf_reader() {
  local folder=$source_folder/build/formats/bcf earlier=bcf-client==0.7.10
  python3 -m venv "$folder" && "$folder/bin/pip" install --quiet bcf-client xmlschema >&2
  mkdir -p "$folder/schemas"
  "$folder/bin/pip" download --quiet --no-deps --no-binary :all: --dest "$folder/schemas" "$earlier" >&2
  tar -xzf "$folder"/schemas/bcf_client-*.tar.gz -C "$folder/schemas" --wildcards '*/xsd/*.xsd' \
    --transform 's:.*/v2/xsd/:2.1/:' --transform 's:.*/v3/xsd/:3.0/:'
}

# Options for a build that has the room over MPI, where that is installed, for tests on few ranks: those on more, and under
# sanitizers, are a step of --all.
options_for_ranks() {
  if command -v mpicxx >/dev/null; then
    printf '%s\n' -DTOCCATA_WITH_MPI=ON '-DTOCCATA_TEST_RANKS=1;2;3' -DTOCCATA_TEST_RANKS_SANITIZED=OFF
  else
    printf '%s\n' -DTOCCATA_WITH_MPI=OFF
  fi
}

# run_tests [--all | NAME…]: everything that judges a commit, or the tests of a room or with a name. The last thing
# printed is the summary of the tests, or of the part that failed.
run_tests() {
  if [[ ${1-} == --all ]]; then
    shift
    install_packages packages-test
    exec python3 "$source_folder/tools/test_all.py" "$@"
  fi
  install_packages packages packages-test
  lock_build_folder
  if [[ $# -gt 0 ]]; then
    run_named_tests "$@"
    return
  fi
  local ranks
  install_packages packages-mpi
  mapfile -t ranks < <(options_for_ranks)
  configure_tests ON "${ranks[@]}"
  build release
  run_ctest release
}

# configure_tests [ON | OFF [OPTION…]]: files of tests and benchmarks are compiled without optimisation, unlike what they test, and those
# of tests once for two programs: one with the libraries as users get them, and unless OFF one with those under sanitizers.
# CGAL's second opinion is left to --all. The Python package has its test where there is a package index.
configure_tests() {
  configure release -DTOCCATA_BUILD_TESTS=ON -DTOCCATA_TEST_SANITIZED="${1-ON}" -DTOCCATA_BUILD_BENCH=ON -DTOCCATA_BENCH_WITH_PEERS=OFF -DTOCCATA_BENCH_ONLY_TESTED=ON -DTOCCATA_TEST_WITH_CGAL=OFF -DTOCCATA_TEST_PYTHON=ON -DTOCCATA_TEST_OPTIONS=-O0 "${@:2}"
}

# run_named_tests NAME…: each a room of tests/ (only its program is built, and not under sanitizers), or a part of a test's
# name.
run_named_tests() {
  local name patterns=() targets=() ranks=() of_rooms=yes
  for name in "$@"; do
    if [[ $name == distributed ]]; then
      install_packages packages-mpi
      mapfile -t ranks < <(options_for_ranks)
      patterns+=("^$name/")
      targets+=(test_distributed toccata_bench_ranks toccata_crowd_ranks toccata_check_ranks toccata_command)
    elif compgen -G "$source_folder/tests/$name/*_test.cpp" >/dev/null; then
      patterns+=("^$name/")
      targets+=("test_$name")
    else
      patterns+=("$name")
      of_rooms=no
    fi
  done
  local left_out=()
  if [[ $of_rooms == no ]]; then targets=(); else left_out=(-E /sanitized-); fi
  configure_tests ON "${ranks[@]}"
  build release "${targets[@]}"
  run_ctest release --no-tests=error "${left_out[@]}" -R "$(
    IFS='|'
    echo "${patterns[*]}"
  )"
}

# run_ctest PRESET OPTION…: the tests built in build/PRESET; those that fail show what they printed.
run_ctest() {
  local folder=$source_folder/build/$1
  shift
  ctest --test-dir "$folder" --output-on-failure --timeout 300 -j "$(nproc)" "$@" 9>&-
}

# The test programs of rooms that compare with CGAL.
programs_with_cgal() {
  (cd "$source_folder/tests" && ls -- */*_cgal_*.cpp) | sed 's|\(.*\)/.*|test_\1|' | sort -u
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

# bench_python WORD…: the Python package and its peers, in an environment of their own, measured by a script.
bench_python() {
  build_library || return 2
  local environment=$source_folder/build/python/bench
  if [[ ! -x $environment/bin/python ]]; then python3 -m venv "$environment"; fi
  say "installing the package and its peers: python-fcl, coal, trimesh (and scipy, which it needs), pybullet"
  (cd "$source_folder" && "$environment/bin/pip" install --quiet --disable-pip-version-check . python-fcl coal trimesh scipy pybullet) >&2 || return 2
  "$environment/bin/python" "$source_folder/apps/bench/python/measure_python.py" --library "$source_folder/build/release" "$@"
}

# The programs that mpirun starts.
build_ranks() {
  install_packages packages packages-mpi
  (lock_build_folder && configure release -DTOCCATA_WITH_MPI=ON && build release toccata_bench_ranks)
}

# What Python's batches are compared with, in C++.
build_library() {
  install_packages packages packages-bench
  (lock_build_folder && configure release && build release toccata)
}

# build_bench yes|no: yes, so that CMake looks for the peers again.
build_bench() {
  lock_build_folder
  if [[ $1 == yes ]]; then rm -f "$source_folder/build/release/.configured-with"; fi
  configure release -DTOCCATA_BUILD_BENCH=ON -DTOCCATA_BENCH_WITH_PEERS=ON -DTOCCATA_BENCH_ONLY_TESTED=OFF && build release toccata_bench
}
