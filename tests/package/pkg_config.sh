#!/usr/bin/env bash
# usage: pkg_config.sh PREFIX FOLDER COMPILER — builds and runs the consumer with pkg-config alone, against a copy of the
# installed tree, because that tree must work wherever it is moved to.
set -eu
prefix=$1 folder=$2 compiler=$3
sources=$(dirname "$0")
rm -rf "$folder"
mkdir -p "$folder"
cp -r "$prefix" "$folder/moved"
PKG_CONFIG_PATH=$(dirname "$(find "$folder/moved" -name toccata.pc)")
export PKG_CONFIG_PATH
for pair in consumer:toccata consumer_of_reports:toccata-reports; do
  program=${pair%:*}
  # shellcheck disable=SC2046
  "$compiler" -std=c++20 -Wall -Wextra -Werror "$sources/$program.cpp" -o "$folder/$program" $(pkg-config --cflags --libs "${pair#*:}")
  "$folder/$program"
done
