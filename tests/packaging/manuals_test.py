#!/usr/bin/env python3
"""Holds manual pages and completions to --help, and lets bash and zsh complete for real: manuals_test.py BIN

Each flag that --help, or --help-all of a command, shows stands in its manual page with the same value and help, and no other. `man` reads
the pages without a warning, and shells offer every flag, value and command; what is not installed is skipped, loudly.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAMS = ['tilemend', 'tilemend-coordinator', 'tilemend-worker']
faults = []


def output(*words, **more):
    return subprocess.run(words, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)


def check(condition, text):
    if not condition:
        faults.append(text)


def flags_of_help(text):
    """{flag: (value, help)} of lines '  -o, --output FORMAT   help', which may go on below the help."""
    found = {}
    for line in re.sub(r'\n {34}(?=\S)', ' ', text).splitlines():
        match = re.match(r'  (?:-\w, |    )--([\w-]+)(?: (\S+))?  +(.*)', line)
        if match:
            found[match.group(1)] = (match.group(2) or '', match.group(3))
    return found


def flags_of_page(text):
    """{section: {flag: (value, help)}} of a page."""
    plain = lambda troff: troff.replace('\\-', '-').replace('\\e', '\\').replace('\\&', '')
    sections, section, lines = {}, '', text.splitlines()
    for at, line in enumerate(lines):
        match = re.match(r'\.S[SH] (.*)', line)
        if match:
            section = plain(match.group(1)).split(' ')[0]
            sections.setdefault(section, {})
        if line == '.TP':
            shown = re.sub(r'\\f[BIR]', '', plain(lines[at + 1]))
            match = re.fullmatch(r'(?:-\w, )?--([\w-]+)(?: (\S+))?', shown)
            check(match, f'no flag: {shown}')
            if match:
                sections[section][match.group(1)] = (match.group(2) or '', plain(lines[at + 2]))
    return sections


def commands_of(program):
    text = output(program, '--help').stdout.split('help COMMAND')[0] if program.endswith('/tilemend') else ''
    return re.findall(r'^  (\w+) ', text, re.M)


def check_page(program):
    name = os.path.basename(program)
    page = output(program, '--describe', 'man').stdout
    sections = flags_of_page(page)
    check(sections.get('OPTIONS') == flags_of_help(output(program, '--help').stdout), f'{name}: OPTIONS')
    for command in commands_of(program):
        shown = flags_of_help(output(program, command, '--help-all').stdout)
        check(shown and sections.get(command) == shown, f'{name} {command}: other flags than --help shows')
    if shutil.which('man'):
        said = output('man', '-l', '--warnings', '-', input=page)
        check(said.returncode == 0 and not said.stderr, f'{name}: man says {said.stderr}')
        check(name.upper() in said.stdout, f'{name}: man shows nothing')
    else:
        print('SKIPPED in part: no man, which reads the pages')


def completions_of_bash(program, words):
    """What bash offers for the last of `words`."""
    line = ' '.join(f"'{w}'" for w in words)
    script = (f'source <("{program}" --describe bash)\nCOMP_WORDS=({line}); COMP_CWORD={len(words) - 1}\n'
              f'_{os.path.basename(program).replace("-", "_")}\nprintf "%s\\n" "${{COMPREPLY[@]}}"')
    done = output('bash', '--norc', '-c', script)
    check(not done.stderr, f'bash: {done.stderr}')
    return set(done.stdout.split())


ZSH = r'''
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'PS1="@@ "; stty columns 4000 -echo'
zpty -w shell 'fpath=("$FOLDER" $fpath); autoload -U compinit; compinit -u -d "$FOLDER/dump"'
zpty -w shell 'setopt no_list_beep no_auto_menu'
zpty -w shell 'print READ''Y'
zpty -r -m shell line '*READY*@@ *'
zpty -n -w shell "$LINE"$'\t'
zpty -n -w shell $'\C-u'"print EN''D"$'\n'
zpty -r -m shell line '*END*'
print -r -- "$line"
'''


def completions_of_zsh(program, words):
    """What zsh writes when the tabulator is pressed after `words`."""
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.basename(program)
        with open(os.path.join(folder, '_' + name), 'w') as file:
            file.write(output(program, '--describe', 'zsh').stdout)
        env = dict(os.environ, FOLDER=folder, LINE=' '.join([name] + words), TERM='dumb')
        return output('zsh', '-f', '-c', ZSH, env=env, cwd=folder, timeout=60).stdout


def check_settings(bin_folder):
    """One file may hold the settings of all programs."""
    pages = [output(os.path.join(bin_folder, program), '--describe', 'man').stdout for program in PROGRAMS]
    names = {name for page in pages for name in re.findall(r'TILEMEND_([A-Z_]+)\b', page.replace('\\-', '-'))} - {'CONFIG'}
    check(len(names) > 20, f'settings: {names}')
    with tempfile.NamedTemporaryFile('w') as file:
        file.writelines(f'{name.lower().replace("_", "-")} = true\n' for name in sorted(names))
        file.flush()
        for words in (['tilemend', 'list', '--no-such'], ['tilemend-coordinator', '--no-such'], ['tilemend-worker', '--no-such']):
            said = output(os.path.join(bin_folder, words[0]), *words[1:], env=dict(os.environ, TILEMEND_CONFIG=file.name))
            check('unknown flag --no-such' in said.stderr, f'{words[0]} with the settings of all: {said.stderr}')


def check_shells(bin_folder):
    tilemend = os.path.join(bin_folder, 'tilemend')
    for program in PROGRAMS:
        path = os.path.join(bin_folder, program)
        for command in commands_of(path) or ['']:
            shown = output(path, command, '--help-all').stdout if command else output(path, '--help').stdout
            wanted = {'--' + flag for flag in flags_of_help(shown)}
            words = [program] + ([command] if command else [])
            offered = completions_of_bash(path, words + ['--'])
            check(offered == wanted, f'bash offers {offered ^ wanted} too much or too little for {words}')
    check(set(commands_of(tilemend)) < completions_of_bash(tilemend, ['tilemend', '']), 'bash: commands')
    cases = [(['run', 'scene', '--textures', ''], {'copy', 'link', 'off'}), (['get', 'x', '-o', 'j'], {'json'}),
             (['run', 'scene', '--textures', '=', 'l'], {'link'}), (['help', 'wo'], {'workers'})]
    for words, wanted in cases:
        check(completions_of_bash(tilemend, ['tilemend'] + words) == wanted, f'bash: {words}')
    check('/usr/' in ''.join(completions_of_bash(tilemend, ['tilemend', 'run', 'x', '--out', '/us'])) + '/', 'bash: folders')
    if not shutil.which('zsh'):
        print('SKIPPED in part: no zsh')
        return
    for program, words, wanted in [('tilemend', ['su'], ['submit']), ('tilemend', ['run', 'x', '--tex'], ['--texture']),
                                   ('tilemend', ['run', 'x', '--textures', 'li'], ['link']),
                                   ('tilemend', ['help', 'work'], ['workers']),
                                   ('tilemend-coordinator', ['--metrics-to'], ['--metrics-token=']),
                                   ('tilemend-worker', ['--log', 'js'], ['json'])]:
        said = completions_of_zsh(os.path.join(bin_folder, program), words)
        for text in wanted:
            check(text in said, f'zsh: {program} {words}: no {text} in {said!r}')


def main():
    bin_folder = os.path.abspath(sys.argv[1])
    for program in PROGRAMS:
        check_page(os.path.join(bin_folder, program))
    check_settings(bin_folder)
    check_shells(bin_folder)
    if faults:
        sys.exit('FAILED\n' + '\n'.join(faults))
    print('manuals and completions: passed')


if __name__ == '__main__':
    main()
