# docs/tutorial/fmu-controller.c, compiled, holds the tension through the archive that `hawser fmu` writes; what the command
# says of wrong arguments.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

run_hawser 0 fmu pull.yaml
says out "pull.fmu: FMI 3.0"
exists pull.fmu
run_hawser 0 fmu pull.yaml --fmi 3 -q -o again.fmu
silent out
cmp -s "$work/pull.fmu" "$work/again.fmu" || fail "two archives of the same case differ"
run_hawser 0 fmu pull.yaml --fmi 2 -o two.fmu --set friction.mu=0.1
says out "FMI 2.0"
run_hawser 2 fmu pull.yaml --fmi 4
says err "--fmi 4"
run_hawser 2 fmu nowhere.yaml
run_hawser 4 fmu pull.yaml -o nowhere/at/all.fmu
missing nowhere
rm -f "$work"/*.fmu

cp "$source/tests/data/hold-tension.yaml" "$work"
run_hawser 0 fmu hold-tension.yaml -o hold.fmu
what="docs/tutorial/fmu-controller.c"
cp "$source/docs/tutorial/fmu-controller.c" "$work/example.c"
${CC:-cc} -std=c11 -Wall -Wextra -Werror "$work/example.c" -o "$work/example" -ldl || { fail "$what: does not compile"; finish; }
python3 - "$work" >"$work/arguments" <<'END' || { fail "$what: no archive"; finish; }
import re, sys, zipfile
work = sys.argv[1]
with zipfile.ZipFile(work + "/hold.fmu") as z:
    z.extractall(work)
    xml = z.read("modelDescription.xml").decode()
token = re.search(r'instantiationToken="([^"]*)"', xml).group(1)
at = [re.search(rf'name="{name}" valueReference="(\d+)"', xml).group(1) for name in ("winch.force", "winch.speed", "inputs.ramp")]
print(f"{work}/binaries/x86_64-linux/hold_tension.so", token, f"{work}/resources/", *at)
END
# shellcheck disable=SC2046 # one word an argument
"$work/example" $(cat "$work/arguments") >"$work/out" 2>"$work/err" || fail "$what: does not run"
silent err
says out "t = 2.0 s: 505" "t = 5.0 s:"
awk '/t = 5.0 s/ && ($5 < 792 || $5 > 808) { exit 1 }' "$work/out" || { fail "$what: the tension is not held:"; cat "$work/out" >&2; }
finish
