# Bash completion for dsphere. Commands, options and their words are read from --help, so they are always the program's.

_dsphere() {
    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} program=${COMP_WORDS[0]} command= help words
    local k
    for ((k = 1; k < COMP_CWORD; k++)); do
        [[ ${COMP_WORDS[k]} == -* ]] || { command=${COMP_WORDS[k]}; break; }
    done
    if [[ -z $command ]]; then
        words=$("$program" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\).*/\1/p')
        COMPREPLY=($(compgen -W "$words --help --version" -- "$word"))
        return
    fi
    help=$("$program" "$command" --help 2>/dev/null)
    # "  --marcher exact|naive" and, of a positional, "  kind moon|fractal REQUIRED": the words stand behind the name.
    if [[ $previous == -* ]]; then
        words=$(sed -n "s/^  \(.*,\)\?$previous \([a-z-]*|[a-z|-]*\).*/\2/p" <<<"$help")
    elif [[ $previous == "$command" ]]; then
        words=$(sed -n 's/^  [a-z]* \([a-z]*|[a-z|]*\) REQUIRED.*/\1/p' <<<"$help")
    fi
    if [[ $word == -* ]]; then
        words=$(sed -n 's/^  \(-[a-z],\)\?\(--[a-z-]*\).*/\2/p' <<<"$help")
    fi
    COMPREPLY=($(compgen -W "${words//|/ }" -- "$word"))
    ((${#COMPREPLY[@]})) || compopt -o default
}
complete -F _dsphere dsphere
