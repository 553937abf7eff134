# Help, version, and every way to get the command line wrong: exit status 2 and a message that helps.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
version=$(sed -n 's/^project(hawser VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")

for flag in --help -h help; do
    run_hawser 0 $flag
    says out "Usage: hawser COMMAND CASE" "run" "check" "theory"
    silent err
done
run_hawser 0 help validate
says out "Usage: hawser validate" "--filter TEXT" "--fast" "Exit status"
for command in run check theory; do
    for order in "$command --help" "$command -h" "help $command" "$command pull.yaml --help"; do
        run_hawser 0 $order
        says out "Usage: hawser $command CASE" "--set KEY=VALUE" "Exit status"
        silent err
    done
    run_hawser 0 $command --version
    says out "hawser $version"
done
for flag in --version -V; do
    run_hawser 0 $flag
    says out "hawser $version"
    silent err
done
run_hawser 0 run --help
says out "--output DIR" "--threads N" "--linear-solver KIND" "--quiet" "130"

run_hawser 2
says err "Usage: hawser COMMAND CASE"
run_hawser 2 rum pull.yaml
says err "unknown command 'rum'" "did you mean 'run'"
run_hawser 2 thoery pull.yaml
says err "did you mean 'theory'"
run_hawser 2 xyzzyplugh pull.yaml
says err "unknown command 'xyzzyplugh'" "--help"
run_hawser 2 --versoin
says err "unknown option '--versoin'" "did you mean '--version'"
run_hawser 2 help rnu
says err "did you mean 'run'"
run_hawser 2 run pull.yaml --qiet
says err "unknown option '--qiet'" "did you mean '--quiet'"
run_hawser 2 run pull.yaml --thread=2x
says err "--threads 2x"
run_hawser 2 run pull.yaml --tread 2
says err "did you mean '--threads'"
run_hawser 2 run pull.yaml -x
says err "unknown option '-x'"
run_hawser 2 check pull.yaml --threads 2
says err "unknown option '--threads'"
run_hawser 2 theory pull.yaml -o somewhere
says err "theory: -o is of --report"
run_hawser 2 place pull.yaml --with ropes
says err "--with ropes: 'machines' or 'pits' can be used"
run_hawser 2 place pull.yaml --push '5 m'
says err "theory.machine_push" "expected a force"
for option in -o --output --set --threads --linear-solver; do
    run_hawser 2 run pull.yaml $option
    says err "$option needs a value"
done
run_hawser 2 run
says err "run needs a case file"
run_hawser 2 run ''
says err "run needs a case file"
run_hawser 2 run pull.yaml second.yaml
says err "second.yaml"
for n in 0 -1 3 two 1.5 '' 99999999999999999999; do
    run_hawser 2 run pull.yaml --threads "$n"
    says err "--threads" "1 or 2"
done
for setting in duration =5 ''; do
    run_hawser 2 run pull.yaml --set "$setting"
    says err "KEY=VALUE"
done
# what a terminal would obey is not passed on to it
run_hawser 2 run pull.yaml --threads "$(printf '\033[31m\r')"
says err "--threads ?[31m?: 1 or 2"
run_hawser 2 theory pull.yaml --format xml
says err "--format xml" "'json'"
missing results
finish
