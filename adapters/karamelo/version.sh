#!/bin/sh
# The commit that karamelo was built from, which it prints when it starts.
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
echo quit > "$folder/input.mpm"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
cd "$folder" && "$1" -i input.mpm 2>&1 | sed -n 's/^.*SHA1:\([0-9a-f]\{10\}\).*$/\1/p' | head -n 1
