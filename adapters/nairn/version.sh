#!/bin/sh
# The version that NairnMPM says it is, as 19.0 of "NairnMPM 19.0 build 0".
"$1" -H 2>&1 | sed -n 's/^.*NairnMPM \([0-9][0-9.]*\).*$/\1/p' | head -n 1
