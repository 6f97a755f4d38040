#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The last job of bake_level.sh, after its array: DIR
set -eu
exec "$WELKIN" merge "$1"
