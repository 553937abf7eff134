# Words of a page that are SI units, alone or behind a number; the first line is the user's title. Status 1 if there are any.
BEGIN {
    n = split("N kN daN MN mm cm m km m2 mm2 cm2 N/m kN/m N/mm kN/mm Pa kPa MPa GPa N/mm2 kg kg/m kg/m3 J kJ W kW m/s " \
              "mm/s m/min m/s2 m-1", unit, " ")
    for (i = 1; i <= n; i++) si[unit[i]] = 1
}
FNR > 1 {
    line = $0
    gsub(/[(),;:'"+]/, " ", line)
    k = split(line, word, /[ \t]+/)
    for (i = 1; i <= k; i++) {
        sub(/^-?[0-9][0-9.e+-]*/, "", word[i])
        sub(/\.$/, "", word[i])
        if (word[i] in si) {
            print word[i] " in: " $0
            bad = 1
        }
    }
}
END { exit bad }
