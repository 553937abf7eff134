# Completion of hawser's command line for bash. Written by packaging/help_pages.py: do not edit.

# _hawser_offer WHAT: files, folders, or one of the words.
_hawser_offer() {
    case $1 in
    files) mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    folders | /) mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    *.yaml) mapfile -t COMPREPLY < <(compgen -f -X '!*.yaml' -- "$current"; compgen -d -- "$current") ;;
    '*') mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    *) mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current") ;;
    esac
    [[ $1 != files && $1 != folders && $1 != / && $1 != *'*'* ]] || compopt -o filenames 2>/dev/null
}

# _hawser_word OPTIONS SUBJECT: an option where one is begun, else what the command is about.
_hawser_word() {
    if [[ $current == -* ]]; then _hawser_offer "$1"; else _hawser_offer "$2"; fi
}

_hawser() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()
    if [[ $COMP_CWORD -eq 1 ]]; then
        _hawser_offer 'run check theory validate library route report plot study compare fmu upgrade schema job place desk convert help --help --version'
        return
    fi
    case ${COMP_WORDS[1]} in
    help) _hawser_offer 'run check theory validate library route report plot study compare fmu upgrade schema job place desk convert' ;;
    run)
        case $previous in
        -o|--output|--resume) _hawser_offer 'folders' ;;
        --set|--sensitivities) _hawser_offer '' ;;
        --threads) _hawser_offer '1 2' ;;
        --linear-solver) _hawser_offer 'auto block bordered klu' ;;
        --tolerance) _hawser_offer '1% 0.5% 2%' ;;
        --effort) _hawser_offer '6 20 60' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        --tables) _hawser_offer 'all facts pieces limits heads sections' ;;
        *) _hawser_word '--output --set --threads --linear-solver --resume --certify --tolerance --effort --sensitivities --report --pdf --strict --keep-going --format --units --tables --verbose --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    check)
        case $previous in
        --set) _hawser_offer '' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--set --format --units --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    theory)
        case $previous in
        --tables) _hawser_offer 'all facts pieces limits heads sections' ;;
        -o|--output|--crew) _hawser_offer 'files' ;;
        --set) _hawser_offer '' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--tables --report --pdf --output --strict --sensitivities --crew --set --format --units --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    validate)
        case $previous in
        --filter) _hawser_offer '' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--filter --fast --format --units --quiet --help --version' '' ;;
        esac
        ;;
    library)
        case $previous in
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--format --units --quiet --help --version' 'cables ropes rollers ducts friction reels' ;;
        esac
        ;;
    route)
        case $previous in
        --name|--layer|--from|--to|--tolerance|--join|--sheet|--radius) _hawser_offer '' ;;
        --units) _hawser_offer 'mm m ft' ;;
        --profile|-o|--output|--picture) _hawser_offer 'files' ;;
        --ignore) _hawser_offer 'all facts pieces limits heads sections' ;;
        --format) _hawser_offer 'table json csv' ;;
        *) _hawser_word '--name --layer --units --profile --reverse --from --to --tolerance --join --sheet --ignore --radius --output --picture --json --format --quiet --help --version' '*' ;;
        esac
        ;;
    report)
        case $previous in
        -o|--output) _hawser_offer 'files' ;;
        *) _hawser_word '--output --pdf --quiet --help --version' '/' ;;
        esac
        ;;
    plot)
        case $previous in
        -o|--output) _hawser_offer 'folders' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--output --units --quiet --help --version' '/' ;;
        esac
        ;;
    study)
        case $previous in
        -o|--output) _hawser_offer 'folders' ;;
        --jobs|--tasks|--task) _hawser_offer '1 2' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--output --jobs --slurm --tasks --mpi --fresh --format --units --quiet --help --version --task' '*.yaml' ;;
        esac
        ;;
    compare)
        case $previous in
        --align) _hawser_offer 'length start' ;;
        --shift) _hawser_offer '' ;;
        --band) _hawser_offer '5% 10% 20%' ;;
        --page) _hawser_offer 'files' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--align --shift --band --raw --page --report --format --json --units --quiet --help --version' '*' ;;
        esac
        ;;
    fmu)
        case $previous in
        -o|--output) _hawser_offer 'files' ;;
        --fmi) _hawser_offer '2 3' ;;
        --set) _hawser_offer '' ;;
        *) _hawser_word '--output --fmi --set --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    upgrade)
        case $previous in
        -o|--output) _hawser_offer 'files' ;;
        *) _hawser_word '--output --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    schema)
        case $previous in
        *) _hawser_word '--json --quiet --help --version' 'case study job summary' ;;
        esac
        ;;
    job)
        case $previous in
        -o|--output|--crew|--xlsx) _hawser_offer 'files' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--report --pdf --output --crew --xlsx --format --units --quiet --strict --help --version' '*.yaml' ;;
        esac
        ;;
    place)
        case $previous in
        --push|--lubricant|--set) _hawser_offer '' ;;
        --with) _hawser_offer 'auto block bordered klu' ;;
        -o|--output) _hawser_offer 'files' ;;
        --format) _hawser_offer 'table json csv' ;;
        --units) _hawser_offer 'si us' ;;
        *) _hawser_word '--push --with --lubricant --output --strict --set --format --units --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    desk)
        case $previous in
        -o|--output) _hawser_offer 'files' ;;
        *) _hawser_word '--output --quiet --help --version' '*.yaml' ;;
        esac
        ;;
    convert)
        case $previous in
        -o|--output) _hawser_offer 'files' ;;
        --unit) _hawser_offer 'mm m ft' ;;
        --up) _hawser_offer 'y z' ;;
        --memory|--time) _hawser_offer '' ;;
        *) _hawser_word '--output --unit --up --memory --time --quiet --help --version' '*' ;;
        esac
        ;;
    esac
}
complete -F _hawser hawser
