# The validation suite's fast half: all within tolerance; choosing cases; formats; what is refused.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

run_hawser 0 validate --fast
says out "Validation" "straight" "capstan-90" "wave-axial" "outside their tolerance          0"
silent err

run_hawser 0 validate --filter wave-axial --format csv
says out "case,quantity,unit,expected,found,error,tolerance,in,verdict,source" "wave-axial,wave speed,m/s,"
run_hawser 0 validate --filter=slope-at-rest --format json
says out '"case": "slope-at-rest"' '"count": 1'

run_hawser 2 validate --filter no-such-case
says err "no validation case has 'no-such-case' in its name"
run_hawser 2 validate cases/straight.yaml
says err "validate takes no case file"
run_hawser 2 validate --format xml
says err "--format xml"
run_hawser 2 run pull.yaml --fast
says err "unknown option '--fast'"
finish
