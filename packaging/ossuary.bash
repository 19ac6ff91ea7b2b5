# Completion for bash. Commands and options are what the programs' help says.
_ossuary_help() {
    "$@" --help 2> /dev/null
}

_ossuary() {
    local word=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]} command='' words
    compopt -o default
    local i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        [[ ${COMP_WORDS[i]} == -* ]] || { command=${COMP_WORDS[i]}; break; }
    done
    if [[ $word == -* ]]; then
        words=$(_ossuary_help "$program" ${command:+"$command"} | grep -oE -- '(^|[ ,])--?[a-z][a-z-]*' | tr -d ' ,')
    elif [[ -z $command && ${program##*/} == ossuary ]]; then
        words=$(_ossuary_help "$program" | sed -n '/^Subcommands:/,$s/^  \([a-z][a-z-]*\) .*/\1/p')
    fi
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
_ossuary_server() {
    local word=${COMP_WORDS[COMP_CWORD]}
    compopt -o default
    [[ $word == -* ]] || return 0
    mapfile -t COMPREPLY < <(compgen -W "$(_ossuary_help "${COMP_WORDS[0]}" | grep -oE -- '(^|[ ,])--?[a-z][a-z-]*' | tr -d ' ,')" -- "$word")
}
complete -F _ossuary ossuary
complete -F _ossuary_server ossuary-server
