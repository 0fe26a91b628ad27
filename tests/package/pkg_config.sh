#!/usr/bin/env bash
# usage: pkg_config.sh PREFIX FOLDER COMPILER — builds and runs the consumer with pkg-config alone, against a copy of the
# installed tree, because that tree must work wherever it is moved to.
set -eu
prefix=$1 folder=$2 compiler=$3
consumer=$(dirname "$0")/consumer.cpp
rm -rf "$folder"
mkdir -p "$folder"
cp -r "$prefix" "$folder/moved"
PKG_CONFIG_PATH=$(dirname "$(find "$folder/moved" -name toccata.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046
"$compiler" -std=c++20 -Wall -Wextra -Werror "$consumer" -o "$folder/consumer" $(pkg-config --cflags --libs toccata)
"$folder/consumer"
