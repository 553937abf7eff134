#!/bin/sh
# Builds the Python package: a wheel for every Python from 3.9 on, and says how to install it (docs/guide/python.md).
# Usage: sh scripts/python.sh
set -eu

cd "$(dirname "$0")/.."
sh scripts/setup.sh --python
rm -rf build/release/python/dist build/release/python/wheel.stamp
sh scripts/build.sh release hawser hawser_python
wheel=$(ls "$PWD"/build/release/python/dist/*.whl) || {
    echo "python.sh: no wheel was made; what was missing stands in build/release/build.log" >&2
    exit 1
}
cat <<EOF
Wheel: $wheel

It needs Debian's numpy and pandas, or others; into an environment of your own that sees Debian's packages:
    /usr/bin/python3 -m venv --system-site-packages ENV
    ENV/bin/pip install --no-index --no-deps $wheel
    ENV/bin/python -c 'import hawser; print(hawser.__version__)'
EOF
