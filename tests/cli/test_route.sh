# The command route: what a file holds, in each form; its choices; files that it writes are read again; what cannot be read.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
cp "$source"/cases/routes/tunnel* "$work"

run_hawser 0 route tunnel.xml
says out "Routes of a file" "tunnel.xml" "1 m, meter" "132.028" "453120.250" "deviation"
silent err
run_hawser 0 route tunnel.ifc --json
says out '"source": "tunnel.ifc"' '"alignments": [' '"name": "tunnel"' '"length_m": 132.02' '"horizontal_length_m": 132.0' '"start": [' '"end": [' \
    '"pieces": 7' '"least_radius_m": 15.0' '"deviation_max_m"' '"ignored": []'
run_hawser 0 route tunnel.dxf --format csv
says out "name,layer,station_m,length_m" "CENTRE,CENTRE,0,131.9999" "WALLS,WALLS,0,30"
run_hawser 0 route tunnel.dxf --layer centre --profile tunnel-profile.csv --from 10 --to 60m --reverse --json
says out '"pieces": 3' '"fitted": true' '"horizontal_length_m": 49.9999' '"station_m": 59.9999'

run_hawser 0 route tunnel.gpx
says out "Fitted bends, +- one standard deviation" "20.00"
run_hawser 0 route tunnel.gpx --json
says out '"bends": [' '"radius_sd_m": 0.00'
run_hawser 0 route tunnel.xml --json
says out '"radius_sd_m": null'

# what is written is the same line again, within 0.1 mm
for ending in csv dxf geojson yaml; do
    run_hawser 0 route tunnel.xml -o again.$ending
    exists again.$ending
done
run_hawser 0 route again.csv --json
says out '"horizontal_length_m": 131.99999' '"pieces": 11'
run_hawser 0 route again.dxf --tolerance 5mm --json
says out '"length_m": 132.0276' '"pieces": 7'
{ sed '/^route:/,/^  file/d' "$work/tunnel-csv.yaml"; cat "$work/again.yaml"; } >"$work/again-case.yaml"
run_hawser 0 check again-case.yaml
says out "132.0"

# a page of it, whose name says so
run_hawser 0 route tunnel.dxf --layer centre --profile tunnel-profile.csv --picture tunnel.html
exists tunnel.html
grep -q 'R 20 m, 63.0' "$work/tunnel.html" && grep -q 'line grey' "$work/tunnel.html"
run_hawser 2 route tunnel.dxf --picture tunnel.csv
says err "must end in .html"

# a gap of a drawing is said, and closed by --join
printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 C 10 0 20 0 11 10 21 0 0 LINE 8 C 10 10.3 20 0 11 20 21 0 0 ENDSEC 0 EOF >"$work/gap.dxf"
run_hawser 0 route gap.dxf --json
says out '"gap of 0.3 m at 10.300, 0.000, layer'
run_hawser 2 route gap.dxf -o gap.csv
says err "2 lines could be meant" "or join them (gap of 0.3 m at"
run_hawser 0 route gap.dxf --join 400mm --tolerance 200mm --json
says out '"length_m": 19.7' '"pieces": 1' '"ignored": []'
run_hawser 2 route gap.dxf --join 0
says err "within 0 m: must be above 0 m"

# corners of straights that are drawn one by one get the radius that is asked for; bends keep their own, and say so
printf '%s\n' 0 SECTION 2 ENTITIES 0 LINE 8 C 10 0 20 0 11 10 21 0 0 LINE 8 C 10 10 20 0 11 10 21 10 0 ENDSEC 0 EOF >"$work/corner.dxf"
run_hawser 0 route corner.dxf --radius 2m --json
says out '"fitted": false' '"deviation_max_m": 0.8284'
says out '"pieces": 3, "fitted": false' '"least_radius_m": 2.0' '"bends": [{"station_m": 8.0' '"turn_deg": 90.0'
for ending in csv dxf yaml; do # the arc is in what is written
    run_hawser 0 route corner.dxf --radius 2m -o bent.$ending
    exists bent.$ending
done
run_hawser 0 route bent.csv --json
says out '"pieces": 3' '"least_radius_m": 2.0'
# corners in space have their radius in a case's route alone
printf 'x (m),y (m),z (m)\n0,0,0\n10,0,1\n10,10,2\n' >"$work/rising.csv"
run_hawser 0 route rising.csv --radius 2m --json -o rising.yaml
says out '"radius_m": 2.0'
grep -q 'radius: 2 m' "$work/rising.yaml" || fail "a route without its radius"
run_hawser 2 route rising.csv --radius 2m -o rising.dxf
says err "corners in space with a radius"
missing rising.dxf
# a sheet of a workbook, and columns that are not used
cp "$source/tests/data/route.xlsx" "$work"
run_hawser 2 route route.xlsx
says err "route.xlsx"
run_hawser 0 route route.xlsx --sheet plan --ignore cost --json
says out '"length_m": 20.0' "the sheet 'Costs'"
silent err
run_hawser 2 route route.xlsx --sheet 4
says err "no sheet '4'; there are 'Costs', 'Plan', 'Heights'"
run_hawser 0 route tunnel.xml --radius 2m
says out "has bends of its own: a 'radius' rounds the corners"

# a drawing whose lines are in blocks that are not inserted says so
printf '%s\n' 0 SECTION 2 BLOCKS 0 BLOCK 2 tunnel 0 LINE 8 C 10 0 20 0 11 10 21 0 0 ENDBLK 0 ENDSEC 0 SECTION 2 ENTITIES 0 CIRCLE 8 C \
    0 ENDSEC 0 EOF >"$work/blocks.dxf"
run_hawser 2 route blocks.dxf
says err "there is none; not read: CIRCLE, lines inside of blocks that are not inserted"

# millimetres, whatever the file says; a unit that is none
run_hawser 0 route tunnel.dxf --layer WALLS --units mm --json
says out '"horizontal_length_m": 0.0300' "where the file says m"
run_hawser 2 route tunnel.gpx --units mm
says err "its places are degrees and its heights metres"
run_hawser 2 route tunnel.dxf --units kg
says err "'kg' is no unit of length"
run_hawser 0 route --help
says out "--units is about the file here"

run_hawser 2 route tunnel.dxf -o all.csv
says err "choose one by 'name' or 'layer'" "WALLS"
missing all.csv
run_hawser 2 route tunnel.xml -o tunnel.pdf
says err "the ending says what is written"
run_hawser 2 route tunnel.xml --name shaft
says err "no line of the name 'shaft'; there are 'tunnel'"
run_hawser 2 route tunnel.xml --from ten
says err "--from ten: must be a length in m or mm"
run_hawser 2 route tunnel.xml --from 200
says err "reaches from station 0 m to 131.99"
run_hawser 2 route none.dxf
says err "none.dxf"
run_hawser 2 route
says err "route needs a file"
run_hawser 2 route tunnel.xml tunnel.ifc
says err "what is 'tunnel.ifc'?"
printf 'AC1032\0\0\0\0' >"$work/tunnel.dwg"
run_hawser 2 route tunnel.dwg
says err "DWG" "save it as DXF"
[ "$(wc -l <"$work/err")" = 1 ] || fail "more than a line about a DWG file"
run_hawser 4 route tunnel.xml -o /nowhere/route.csv

# the drawing changes, the run changes
run_hawser 0 theory tunnel-dxf.yaml --format json
cp "$work/out" "$work/before"
sed -i 's/^132,11.03/132,9.03/' "$work/tunnel-profile.csv"
run_hawser 0 theory tunnel-dxf.yaml --format json
cmp -s "$work/out" "$work/before" && fail "another profile, the same pull"
run_hawser 0 check tunnel-dxf.yaml --set route.file=tunnel.xml --set route.layer="''"
finish
