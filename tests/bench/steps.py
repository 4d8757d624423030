"""Single measurements of a long experiment, each kept in a file, so that a run that was interrupted goes on where it was."""
import hashlib
import json
import os
import re
import sys


class Steps:
    """The measurements that were made with one program, in a folder of its own.

    Those that are missing are taken from the folder of the program `carried`, but for names in which the expression `again` is found:
    for programs that differ in nothing that the measurement depends on. `used` counts the measurements by program.
    """

    def __init__(self, folder, program, carried='', again=''):
        with open(program, 'rb') as file:
            self.own = hashlib.sha256(file.read()).hexdigest()[:12]
        self.folder = os.path.join(folder, self.own)
        os.makedirs(self.folder, exist_ok=True)
        self.carried, self.again, self.used = carried, again, {}

    def kept_at(self, name):
        """The program whose measurement of that name is there and is wanted, or None."""
        programs = [self.own] if not self.carried or self.again and re.search(self.again, name) else [self.own, self.carried]
        return next((p for p in programs if os.path.exists(self.path(p, name))), None)

    def path(self, program, name):
        return os.path.join(os.path.dirname(self.folder), program, name + '.json')

    def get(self, name, make, *arguments):
        """What `make` gave for that name, now or in an earlier run; anything that JSON can hold."""
        program = self.kept_at(name)
        self.used[program or self.own] = self.used.get(program or self.own, 0) + 1
        if program:
            with open(self.path(program, name), encoding='utf-8') as file:
                return json.load(file)
        print(f'  {name}', file=sys.stderr, flush=True)
        result = make(*arguments)
        path = self.path(self.own, name)
        with open(path + '.part', 'w', encoding='utf-8') as file:
            json.dump(result, file)
        os.replace(path + '.part', path)
        return result

    def write_table(self, name, table):
        """Writes a full table beside the measurements. Returns it."""
        with open(os.path.join(self.folder, name + '.md'), 'w', encoding='utf-8') as file:
            file.write(table + '\n')
        return table

    def told(self, machine):
        """The machine and the programs that were used since the last call, as text; the load, at its end, is not that of measurements carried."""
        used, self.used = self.used, {}
        if set(used) <= {self.own}:
            return f'{machine}; program {self.own}'
        return re.sub(r', load [\d.]+$', '', machine) + '; programs ' + ', '.join(f'{name} ({count} of {sum(used.values())} measurements)' for name, count in sorted(used.items()))
