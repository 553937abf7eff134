# scripts/figures.py in its quick mode: one run, every figure with data in it, well-formed; a broken program is an error.
hawser=$1 source=$2 python=$3
. "$source/tests/cli/common.sh"

what="figures.py"
"$python" -B "$source/scripts/figures.py" --quick --hawser "$hawser" --out "$work/f" >"$work/out" 2>"$work/err" || {
    fail "$what: fails"
    cat "$work/err" >&2
}
for name in fig07-speeds fig08-tensions fig09-errors fig10-start fig11-crossing fig12-alpha fig13-pulleys; do
    exists f/$name.svg f/$name.csv
    "$python" -c 'import sys, xml.dom.minidom as x; d = x.parse(sys.argv[1])
sys.exit(not (d.getElementsByTagName("polyline") or d.getElementsByTagName("circle")))' "$work/f/$name.svg" ||
        fail "$what: $name.svg is not well-formed or shows nothing"
done
# the run's own figures: steady speed of the rope, steady tension behind the winch, alpha at A
"$python" -c 'import csv, sys
def last(name, column): return float(list(csv.DictReader(open(sys.argv[1] + "/" + name)))[-1][column])
def near(value, wanted, share): assert abs(value - wanted) <= share * wanted, (value, wanted)
near(last("fig07-speeds.csv", "rope_340_m_per_s"), 0.1, 0.02)
near(last("fig08-tensions.csv", "rope_369_N"), 12830, 0.01)
near(last("fig12-alpha.csv", "case_alpha"), 0.99, 0.02)
near(last("fig13-pulleys.csv", "P32_N"), 2000, 0.4)' "$work/f" 2>"$work/err" || {
    fail "$what: the figures are not the run's"
    cat "$work/err" >&2
}
"$python" -B "$source/scripts/figures.py" --quick --hawser false --out "$work/g" >"$work/out" 2>"$work/err" &&
    fail "$what: a program that fails goes unnoticed"
says err "hawser failed"
finish
