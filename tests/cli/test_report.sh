# `hawser report`, `run --report` and `plot`: files, messages and exit statuses. What is in a page: tests/io/test_report_page.c.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

run_hawser 0 run -o r pull.yaml --report
says out "Report: r/report.html"
exists r/report.html r/inputs.csv r/route.csv
run_hawser 0 run -q -o r2 pull.yaml --report --set title='"</script> \"quoted\""'
silent out
exists r2/report.html
[ "$(grep -c '<script' "$work/r2/report.html")" = "$(grep -c '<script' "$work/r/report.html")" ] || fail "$what: a title made a script"

# the calculation as a page, without a run
run_hawser 0 theory pull.yaml --report
says out "Report: pull-calculation.html"
exists pull-calculation.html
run_hawser 0 theory pull.yaml --report -q -o sheet.html --units us
silent out
exists sheet.html
run_hawser 1 theory pull.yaml --report --strict -q
run_hawser 4 theory pull.yaml --report -o nowhere/sheet.html
says err "cannot write 'nowhere'"
for other in "--tables limits" --sensitivities "--format json"; do
    run_hawser 2 theory pull.yaml --report -o other.html $other
    missing other.html
done

# one folder, with a slash or without; several; where it goes
rm "$work/r/report.html"
run_hawser 0 report r/
says out "Report: r/report.html"
exists r/report.html
run_hawser 0 report r r2
says out "Report: report.html"
exists report.html
run_hawser 0 report r2 -o page.html -q
silent out
exists page.html
missing page.html.part

# a run that was stopped before its end, and one that failed to be written at all
run_hawser 2 report
says err "report needs a folder with results"
run_hawser 2 report nowhere
says err "nowhere" "No such file"
run_hawser 2 report pull.yaml
says err "is no folder"
mkdir "$work/empty"
run_hawser 2 report empty
says err "there is no summary.json"
missing empty/report.html
run_hawser 2 report r r r r r r r
says err "up to 6"
run_hawser 4 report r -o nowhere/page.html
says err "nowhere"
run_hawser 2 report r --pfd
says err "--pdf"

# without a browser --pdf says what to install; the page is there all the same
PATH_BEFORE=$PATH
mkdir "$work/bin"
for tool in rm sh; do ln -s "$(command -v $tool)" "$work/bin/$tool"; done
PATH=$work/bin
rm -f r/report.html
run_hawser_without_browser() {
    what="hawser report --pdf without a browser"
    (cd "$work" && "$hawser" report r --pdf >"$work/out" 2>"$work/err" </dev/null)
    [ $? = 4 ] || failures=$((failures + 1))
}
run_hawser_without_browser
PATH=$PATH_BEFORE
says err "apt-get install chromium"
exists r/report.html

# a name that ends in .pdf is the print's, the page stands beside it (was: HTML in a.pdf, an empty page in a.pdf.pdf)
printf '#!/bin/sh\nfor a; do case $a in --print-to-pdf=*) echo %%PDF-of "$8" "$a" >"${a#*=}";; esac; last=$a; done\n' >"$work/bin/chromium"
printf 'echo "$last" >>"%s/urls"\n' "$work" >>"$work/bin/chromium"
chmod +x "$work/bin/chromium"
PATH=$work/bin:$PATH_BEFORE
for args in "--pdf -o a.pdf" "-o a.pdf" "--pdf -o a.html" "--pdf -o a"; do
    rm -f "$work"/a.* "$work/urls"
    run_hawser 0 report r $args
    says out "Report: a.html" "Printed: a.pdf"
    exists a.html a.pdf
    missing a.pdf.pdf a
    grep -q "^%PDF" "$work/a.pdf" || fail "$what: a.pdf is no print"
    grep -q "/a.html$" "$work/urls" || fail "$what: the browser has not opened the page"
done
PATH=$PATH_BEFORE

# figures
run_hawser 0 plot r
says out "Drawn: 4 figures in r"
exists r/tension.svg r/series.svg r/rollers.svg r/plan.svg
run_hawser 0 plot r -o figures tension plan --units us
exists figures/tension.svg figures/plan.svg
missing figures/rollers.svg
grep -q ", ft" "$work/figures/plan.svg" || fail "$what: no feet"
run_hawser 2 plot r tensions
says err "'tensions' is no figure"
run_hawser 2 plot empty
run_hawser 4 plot r -o pull.yaml
# the desk has the case in it with every file that it names, from wherever that is named
mkdir -p "$work/job/lists"
cp "$source/cases/theory/route-table.csv" "$work/job/line #1.csv"
echo "include: more.yaml" >"$work/job/lists/own.yaml"
echo "{}" >"$work/job/lists/more.yaml"
printf '%s\n' 'include: [lists/own.yaml]' 'route:' '  file: "line #1.csv"' >"$work/job/pull.yaml"
run_hawser 0 desk job/pull.yaml -q
exists pull-desk.html
for name in "line #1.csv" lists/own.yaml lists/more.yaml; do
    entry="\"$name\":\"$(base64 -w 0 "$work/job/$name")\""
    grep -qF -- "$entry" "$work/pull-desk.html" || fail "$what: $name is not in the page"
done
rm "$work/pull-desk.html"
run_hawser 2 desk job/pull.yaml -q -o job/lists/more.yaml
says err "which is an input"
rm "$work/job/line #1.csv"
run_hawser 2 desk job/pull.yaml -q
says err "job/pull.yaml:3" "route.file" "line #1.csv"
missing pull-desk.html

finish
