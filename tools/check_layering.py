#!/usr/bin/env python3
"""Checks which file includes which.

A file of a room (include/toccata/<room>/, src/<room>/) includes only its own room and those before it in
tools/rooms.txt. A public header includes only public headers and the standard library, and of that whatever it names, by
itself or by way of others. The command includes only public headers and its own. Every public header is named by one of the umbrellas in include/toccata, or by a list that one of
them includes, and no folder is a room without a name. The interface stays small: public headers, and the types that a
program meets who includes toccata.hpp, are counted.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = (ROOT / "tools/rooms.txt").read_text().split()
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD_HEADER = re.compile(r"[a-z_0-9]+")
# What such a header includes of its room needs no umbrella that names it again.
LISTS = ["toccata/bounds/all_volumes.hpp"]
# Where the names are that public headers take from the standard library. That they compile alone is tried with these
# precompiled (tests/repository.cmake), which would hide a missing one.
STANDARD = {
    "algorithm": "all_of any_of clamp copy fill find max max_element min min_element sort",
    "array": "array",
    "cmath": "abs fma hypot isfinite isnan nextafter sqrt",
    "compare": "partial_ordering strong_ordering",
    "concepts": "convertible_to copyable default_initializable derived_from floating_point integral invocable same_as",
    "cstddef": "byte ptrdiff_t size_t",
    "cstdint": "int16_t int32_t int64_t int8_t uint16_t uint32_t uint64_t uint8_t uintptr_t",
    "filesystem": "filesystem",
    "functional": "cref function greater hash less plus ref reference_wrapper",
    "initializer_list": "initializer_list",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "addressof make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "optional": "nullopt optional",
    "set": "set",
    "span": "dynamic_extent span",
    "stdexcept": "invalid_argument logic_error runtime_error",
    "string": "string to_string",
    "string_view": "string_view",
    "tuple": "apply tie tuple tuple_element_t",
    "type_traits": "conditional_t decay_t is_invocable_r_v is_same_v is_trivially_copyable_v remove_cv_t remove_cvref_t type_identity",
    "utility": "as_const exchange forward make_pair move pair swap",
    "variant": "get_if holds_alternative monostate variant variant_alternative_t visit",
    "vector": "erase_if vector",
}
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}
STANDARD_NAME = re.compile(r"\bstd::(\w+)")
COMMENT = re.compile(r"//[^\n]*")
MOST_HEADERS, MOST_TYPES = 118, 192
# A struct, class or enumeration at namespace scope.
TYPE = re.compile(r"^(?:template\s*<[^\n]*>\s*(?:requires[^\n]*\n)?)?(?:struct|class|enum class|enum)\s+(\w+)[^;{\n]*\{", re.MULTILINE)


def sources(folder):
    return sorted(p for p in (ROOT / folder).rglob("*") if p.suffix in {".hpp", ".cpp"})


def includes(path):
    return INCLUDE.findall(path.read_text())


def room_of(included):
    """The room that an include in quotes names, or None."""
    parts = included.removeprefix("toccata/").split("/")
    return parts[0] if len(parts) > 1 and parts[0] in ROOMS else None


def check_room_file(path, room, public):
    for quote, included in includes(path):
        if quote == "<":
            if public and not STANDARD_HEADER.fullmatch(included):
                yield f"{path}: a public header includes <{included}>, which is not of the standard library"
            continue
        other = room_of(included)
        if other is None:
            yield f'{path}: "{included}" names no room; write "toccata/<room>/x.hpp" or "<room>/x.hpp"'
        elif ROOMS.index(other) > ROOMS.index(room):
            yield f'{path}: "{included}" is in {other}, which comes after {room} in tools/rooms.txt'
        elif public and not included.startswith("toccata/"):
            yield f'{path}: a public header includes the private "{included}"'


def check_rooms(base, public):
    for path in sources(base):
        parts = path.relative_to(ROOT / base).parts
        if len(parts) == 1 and public:
            continue  # an umbrella, checked on its own
        if parts[0] not in ROOMS:
            yield f"{path}: {parts[0]} is not in tools/rooms.txt"
        else:
            yield from check_room_file(path, parts[0], public)


def check_command():
    """Also what it shares with the benchmarks sees public headers alone."""
    files = sources("apps/toccata") + sources("apps/shared")
    own = {p.name for p in files}
    for path in files:
        for quote, included in includes(path):
            if quote == '"' and not included.startswith("toccata/") and included not in own:
                yield f'{path}: the command includes the private "{included}"'


def check_umbrellas():
    umbrellas = sorted((ROOT / "include/toccata").glob("*.hpp"))
    named = [included for umbrella in umbrellas for _, included in includes(umbrella)]
    public = {str(p.relative_to(ROOT / "include")) for p in sources("include/toccata") if p not in umbrellas}
    listed = [included for header in LISTS for _, included in includes(ROOT / "include" / header)]
    for missing in sorted(public - set(named + listed)):
        yield f'{ROOT}/include/toccata: no umbrella includes "{missing}"'
    for twice in sorted({name for name in named if named.count(name) > 1}):
        yield f'{ROOT}/include/toccata: more than one umbrella includes "{twice}"'


def reached_from(header, known):
    """The header and all public ones that it includes, also by way of others."""
    if header not in known:
        known.add(header)
        for _, included in includes(ROOT / "include" / header):
            if included.startswith("toccata/"):
                reached_from(included, known)
    return known


def check_standard_names():
    for path in sources("include/toccata"):
        reached = reached_from(str(path.relative_to(ROOT / "include")), set())
        included = {name for header in reached for _, name in includes(ROOT / "include" / header)}
        for name in sorted(set(STANDARD_NAME.findall(COMMENT.sub("", path.read_text())))):
            if name not in HEADER_OF:
                yield f"{path}: names std::{name}; say in tools/check_layering.py which header that is of"
            elif HEADER_OF[name] not in included:
                yield f"{path}: names std::{name} and does not include <{HEADER_OF[name]}>"


def check_size():
    headers = sources("include/toccata")
    if len(headers) > MOST_HEADERS:
        yield f"{ROOT}/include/toccata: {len(headers)} public headers, and at most {MOST_HEADERS} are wanted"
    types = {name for header in reached_from("toccata/toccata.hpp", set()) for name in TYPE.findall((ROOT / "include" / header).read_text())}
    if len(types) > MOST_TYPES:
        yield f"{ROOT}/include/toccata/toccata.hpp: brings {len(types)} types, and at most {MOST_TYPES} are wanted"


def main():
    complaints = [*check_rooms("include/toccata", True), *check_rooms("src", False), *check_command(), *check_umbrellas(),
                  *check_standard_names(), *check_size()]
    for complaint in complaints:
        print(complaint.replace(f"{ROOT}/", ""))
    print(f"layering: {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
