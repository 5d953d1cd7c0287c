# Fish completion for dsphere. Commands, options and their words are read from --help, so they are always the program's.

function __dsphere_command
    for word in (commandline -opc)[2..]
        string match -q -- '-*' $word; or begin
            echo $word
            return
        end
    end
    return 1
end

function __dsphere_commands
    dsphere --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\)  *\(.*\)/\1\t\2/p'
end

function __dsphere_options
    dsphere (__dsphere_command) --help 2>/dev/null | sed -n 's/^  \(-[a-z],\)\?\(--[a-z-]*\).*/\2/p'
end

# The words behind the option before the cursor, or those of the command's positional.
function __dsphere_words
    set -l previous (commandline -opc)[-1]
    set -l command (__dsphere_command); or return
    set -l help (dsphere $command --help 2>/dev/null)
    if string match -q -- '-*' $previous
        printf '%s\n' $help | sed -n "s/^  \(.*,\)\?$previous \([a-z-]*|[a-z|-]*\).*/\2/p" | string split '|'
    else if test "$previous" = "$command"
        printf '%s\n' $help | sed -n 's/^  [a-z]* \([a-z]*|[a-z|]*\) REQUIRED.*/\1/p' | string split '|'
    end
end

complete -c dsphere -n 'not __dsphere_command' -f -a '(__dsphere_commands)'
complete -c dsphere -n 'not __dsphere_command' -l help -d 'Print help'
complete -c dsphere -n 'not __dsphere_command' -l version -d 'Print the version'
complete -c dsphere -n __dsphere_command -a '(__dsphere_words)'
complete -c dsphere -n 'string match -q -- "-*" (commandline -ct)' -a '(__dsphere_options)'
