# scripts/plot.py draws a run's results; without matplotlib there is nothing to test.
hawser=$1 source=$2 python=$3
. "$source/tests/cli/common.sh"
"$python" -c 'import matplotlib' 2>/dev/null || python=/usr/bin/python3
"$python" -c 'import matplotlib' 2>/dev/null || { echo "no matplotlib: skipped"; exit 0; }

run_hawser 0 run -q -o r pull.yaml
what="plot.py"
MPLCONFIGDIR=$work/mpl "$python" -B "$source/scripts/plot.py" "$work/r" >"$work/out" 2>"$work/err" || fail "$what: fails"
for name in tension series rollers; do
    exists r/$name.svg r/$name.png
    grep -q '</svg>' "$work/r/$name.svg" || fail "$what: $name.svg is not whole"
done
"$python" -B "$source/scripts/plot.py" "$work" >"$work/out" 2>"$work/err" && fail "$what: draws nothing from an empty folder"
says err "none of stations.csv"
finish
