#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The last job of bake_level.sh, after its array. Argument: DIR
set -eu
exec "$WELKIN" merge "$1"
