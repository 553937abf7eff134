# Cases, good and bad, through check and theory; settings; formats; a standard output that cannot be written.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

run_hawser 0 check pull.yaml
says out "A short pull" "segments" "20" "rollers" "length of the route" "largest winch force by theory" "784.8 N" "Cable and rope" "row"
silent err
run_hawser 0 check pull.yaml --format json
says out '"segments": 20' '"route_length_m": 20.0' '"chain": ['
run_hawser 0 check pull.yaml --format=csv
says out "key,value,unit" "chain_mass_kg,200,kg"

# a bend to the side keeps the grade of a slope; told to lie in one plane it loses it, and that is said
says out "route_grade,no bend to the side changes it"
run_hawser 0 check pull.yaml --set run.keep_going=true --set route.slope=6deg --set route.head_at=20 --set 'route.pieces=[{straight: 10}, {bend: 90 deg, radius: 6, plane: left, grade: plane}, {straight: 5}]'
says out "turns to the side in one plane: from 6.0 to 0.0 deg"

# mu w L = 0.2 * 20 kg/m * 9.81 m/s2 * 20 m of a route full of cable; of the 10 m that a run pulls half of it
run_hawser 0 theory pull.yaml
[ "$(wc -l <"$work/out")" -le 25 ] && [ "$(wc -L <"$work/out")" -le 80 ] || fail "$what: more than 25 lines of 80 columns"
run_hawser 2 theory pull.yaml --tables pieces,piece
says err "no table 'piece': there are all, facts, pieces"
run_hawser 0 theory pull.yaml --tables pieces
says out "The route piece by piece" "784.8"
run_hawser 0 theory pull.yaml --tables all
says out "middle" "784.8 N" "paper  reference" "392.4"
run_hawser 0 theory pull.yaml --format csv
says out "name,from_m,length_m,radius_m,supports,forward_end_N" "row,0,20,,resultant,784.8,0,196.2,"
run_hawser 0 theory pull.yaml --format json
says out '"reference_total_N": 784.8' '"reference_total_N": 392.4' '"stations": [' '"pieces": [' '"directions": ['
run_hawser 0 theory pull.yaml --tables facts --set friction.mu=0.4
says out "1.5696 kN"
run_hawser 0 theory --tables=facts --set friction.mu=0.4 --set friction.mu=0.3 -- pull.yaml
says out "1.1772 kN"

run_hawser 2 check nowhere.yaml
says err "nowhere.yaml" "No such file"
sed 's/^friction.*/frction: {mu: 0.2}/' "$work/pull.yaml" >"$work/bad.yaml"
for command in run check theory; do
    run_hawser 2 $command bad.yaml
    says err "bad.yaml:12" "frction"
    silent out
    run_hawser 2 $command pull.yaml --set friction.mu=much
    says err "--set" "friction.mu"
    run_hawser 2 $command pull.yaml --set nonsense.key=1
    says err "nonsense"
done
run_hawser 2 run pull.yaml --linear-solver fast
says err "linear_solver" "fast"
missing results

# what was printed is lost: that is a failure
if [ -w /dev/full ]; then
    for command in --help --version 'theory pull.yaml' 'check pull.yaml'; do
        (cd "$work" && "$hawser" $command >/dev/full 2>err)
        status=$?
        what="hawser $command >/dev/full"
        [ $status = 4 ] || fail "$what: exit status $status, not 4"
        says err "standard output"
    done
fi
finish
